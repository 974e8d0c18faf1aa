--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may be the monitor: newcomers, where they come from, the token they
--  show, and who is in command already. For th_server.

with Ada.Real_Time;
with Admission.Authentication;
with Admission.Blocklists;
with Admission.Networks;
with Admission.Pending_Connections;
with Schedule;
with Texts;

package Admission.Newcomers with SPARK_Mode is

   procedure Load_Token
     (Path    : Texts.Text;
      Token   : out Admission.Authentication.Token;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with
     Post => (if Path.Length = 0 then Success and then Token.Length = 0
              else Success = (Token.Length > 0));
   --  The token in the file Path, none where Path is empty. Reason says why
   --  where Success is false

   use type Admission.Authentication.Verdict;

   type Gate is private;
   --  Who is let in, and who waits for it

   function Is_Consistent (G : Gate) return Boolean with Ghost;
   --  Whoever is entitled has a right to it: his address is allowed, and he
   --  has sent the right line where a token is asked for

   procedure Set_Up
     (G       : out Gate;
      Allowed : Admission.Networks.List;
      Token   : Admission.Authentication.Token)
   with Post => Is_Consistent (G);
   --  Nobody waits

   procedure Serve (G : in out Gate)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  Waits for what comes next (newcomers, pieces of their lines, the end of
   --  their time, the end of a session) and sees to it: to so many of them,
   --  and a Newcomer_Interval of the table later to the next, however many
   --  come. Every source of them has its turn

private

   subtype Place is Admission.Pending_Connections.Place;

   type Newcomer is record
      From   : Admission.Networks.Peer_Address := (others => 0);
      Limit  : Ada.Real_Time.Time              := Ada.Real_Time.Time_First;
      --  for its token
      Reader : Admission.Authentication.Reader;
   end record;

   type Newcomer_Array is array (Place) of Newcomer;

   Max_Lines : constant := 32;
   --  Of the log, on newcomers that were refused. Then there is one more
   --  each turn, so that a flood does not keep other lines out of the log,
   --  and as many again when nobody was refused for a Refusal_Pause

   subtype Line_Count is Natural range 0 .. Max_Lines;

   subtype Turn_Line_Count is Natural range 0 .. Schedule.Hearings_Per_Turn;

   type Refusal_Log is record
      Lines      : Line_Count := Max_Lines;
      --  that may be written now
      Turn_Lines : Turn_Line_Count := 0;
      --  of these, in this turn
      Unwritten  : Natural := 0;
      --  refusals since the last such line
      Last       : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  refusal
   end record;

   type Defence is record
      Arrivals   : Admission.Blocklists.History;
      --  since there was nobody in the kernel's queue
      Blocked    : Admission.Blocklists.List;
      Unblocking : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  of those who are blocked
   end record;

   type Gate is record
      Allowed  : Admission.Networks.List;
      Token    : Admission.Authentication.Token;
      Table    : Admission.Pending_Connections.Table;
      Places   : Newcomer_Array;
      --  a newcomer waits until it has shown its token. It is kept where
      --  nobody can be told yet whether it is admitted
      Pause    : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  nobody is taken in before: it has just failed
      Rest     : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  nothing is seen to before
      Floods   : Defence;
      Refusals : Refusal_Log;
   end record;

   function Is_Entitled (G : Gate; N : Newcomer) return Boolean is
     (Admission.Networks.Admits (G.Allowed, N.From)
      and then (G.Token.Length = 0
                or else Admission.Authentication.Is_Right (N.Reader, G.Token)))
   with Ghost;

   function Is_Asked (G : Gate; N : Newcomer) return Boolean is
     (Admission.Networks.Admits (G.Allowed, N.From)
      and then G.Token.Length > 0
      and then (if Admission.Authentication.Decision (N.Reader) =
                     Admission.Authentication.Right
                then Admission.Authentication.Is_Right (N.Reader, G.Token)))
   with Ghost;

   function Is_Consistent (G : Gate) return Boolean is
     (Admission.Pending_Connections.Is_Consistent (G.Table)
      and then
        (for all P in Place =>
           (if Admission.Pending_Connections.Is_Kept (G.Table, P) then
               Is_Entitled (G, G.Places (P))
            elsif Admission.Pending_Connections.Is_Taken (G.Table, P) then
               Is_Asked (G, G.Places (P)))));

end Admission.Newcomers;
