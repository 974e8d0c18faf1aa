--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may be the monitor: newcomers, where they come from, the token they
--  show, and who is in command already. For th_server.

with Ada.Real_Time;
with Authentication;
with Monitor_Sockets;
with Networks;
with Texts;

package Admission with SPARK_Mode is

   procedure Load_Token
     (Path    : Texts.Text;
      Token   : out Authentication.Token;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with
     Post => (if Path.Length = 0 then Success and then Token.Length = 0
              else Success = (Token.Length > 0));
   --  The token in the file Path, none where Path is empty. Reason says why
   --  where Success is false

   type Gate is private;
   --  Who is let in, and who waits for it

   function Is_Consistent (G : Gate) return Boolean with Ghost;
   --  Whoever is entitled has a right to it: his address is allowed, and he
   --  has sent the right line where a token is asked for

   procedure Set_Up
     (G       : out Gate;
      Allowed : Networks.List;
      Token   : Authentication.Token)
   with Post => Is_Consistent (G);
   --  Nobody waits

   procedure Serve (G : in out Gate)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  Waits for what comes next (a newcomer, a piece of a line of one, the
   --  end of its time, the end of a session) and sees to it: to one thing,
   --  and a Newcomer_Interval of the table later to the next, however many
   --  come

private

   type Stage_Kind is
     (Nobody,     --  the place is free
      Asked,      --  its token is awaited
      Entitled);  --  to be admitted, or told why that cannot be

   type Newcomer is record
      Stage  : Stage_Kind            := Nobody;
      From   : Networks.Peer_Address := (others => 0);
      Peer   : Texts.Text;           --  the same and its port, for the log
      Limit  : Ada.Real_Time.Time    := Ada.Real_Time.Time_First;
      --  for its token; who has the earlier one came first
      Reader : Authentication.Reader;
   end record;

   type Newcomer_Array is array (Monitor_Sockets.Place) of Newcomer;

   type Gate is record
      Allowed : Networks.List;
      Token   : Authentication.Token;
      Places  : Newcomer_Array;
      Pause   : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  nobody is taken in before: it has just failed
      Rest    : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  nothing is seen to before
   end record;

   function Is_Entitled (G : Gate; N : Newcomer) return Boolean is
     (Networks.Admits (G.Allowed, N.From)
      and then (G.Token.Length = 0
                or else Authentication.Is_Right (N.Reader, G.Token)))
   with Ghost;

   function Is_Asked (G : Gate; N : Newcomer) return Boolean is
     (Networks.Admits (G.Allowed, N.From)
      and then G.Token.Length > 0
      and then Authentication.Is_Open (N.Reader))
   with Ghost;

   function Is_Consistent (G : Gate) return Boolean is
     (for all N of G.Places =>
        (case N.Stage is
            when Nobody   => True,
            when Asked    => Is_Asked (G, N),
            when Entitled => Is_Entitled (G, N)));

end Admission;
