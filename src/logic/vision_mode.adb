--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mode of the vision (F14 to F19): what each command and event does to
--  it, and what is to be sent. Decides; the vision tasks carry out.

package body Vision_Mode with SPARK_Mode is

   --------------
   -- Ask_Open --
   --------------

   procedure Ask_Open (S : in out State; Needed : out Boolean) is
   begin
      Needed := not Is_Open (S);
      if Needed then
         S.Stage := Opening;
      end if;
   end Ask_Open;

   ------------
   -- Opened --
   ------------

   procedure Opened (S : in out State; Success : Boolean) is
   begin
      if S.Stage = Opening then
         S.Stage := (if Success then Streaming else Closed);
      end if;
   end Opened;

   -----------
   -- Close --
   -----------

   procedure Close (S : out State) is
   begin
      S := (others => <>);
   end Close;

   ---------------
   -- Ask_Arena --
   ---------------

   procedure Ask_Arena (S : in out State; Accepted : out Boolean) is
   begin
      Accepted := Is_Open (S);
      if Accepted then
         S.Stage := Searching;
      end if;
   end Ask_Arena;

   --------------
   -- Searched --
   --------------

   procedure Searched (S : in out State; Found : Boolean) is
   begin
      if S.Stage = Searching then
         S.Stage := (if Found then Deciding else Streaming);
      end if;
   end Searched;

   ------------
   -- Decide --
   ------------

   procedure Decide
     (S : in out State; Confirm : Boolean; Valid : out Boolean)
   is
   begin
      Valid := S.Stage = Deciding;
      if Valid then
         S.Stage := Streaming;
         S.Confirmed := Confirm;
      end if;
   end Decide;

   ------------------
   -- Ask_Position --
   ------------------

   procedure Ask_Position
     (S : in out State; On : Boolean; Accepted : out Boolean)
   is
   begin
      Accepted := Is_Open (S) or else not On;
      if Accepted then
         S.Position_On := On;
      end if;
   end Ask_Position;

end Vision_Mode;
