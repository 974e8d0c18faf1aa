--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission of the monitor: th_server checks the address of each new client,
--  its token, and whether another monitor is in command.

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
   --  The token in the file Path, none if Path is empty. Reason explains a
   --  failure

   use type Admission.Authentication.Verdict;

   type Gate is private;
   --  The pending connections and their state

   function Is_Consistent (G : Gate) return Boolean with Ghost;
   --  Invariant: a connection is entitled only if its address is allowed, and
   --  it has sent the right token line if one is required

   procedure Set_Up
     (G       : out Gate;
      Allowed : Admission.Networks.List;
      Token   : Admission.Authentication.Token)
   with Post => Is_Consistent (G);
   --  No pending connection

   procedure Serve (G : in out Gate)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  One turn of th_server: waits for an event (new connection, data,
   --  time-out, end of a session), and handles a limited number of
   --  connections, the sources in turn. Turns are at least a Newcomer_Interval
   --  apart, so a flood cannot take all the processor time

private

   subtype Place is Admission.Pending_Connections.Place;

   type Newcomer is record
      From   : Admission.Networks.Peer_Address := (others => 0);
      Limit  : Ada.Real_Time.Time              := Ada.Real_Time.Time_First;
      --  deadline for its token
      Reader : Admission.Authentication.Reader;
   end record;

   type Newcomer_Array is array (Place) of Newcomer;

   Max_Lines : constant := 32;
   --  Log lines on rejected connections. Then one more each turn, so that a
   --  flood does not displace other lines from the log; all of them again
   --  after a Refusal_Pause without a rejection

   subtype Line_Count is Natural range 0 .. Max_Lines;

   subtype Turn_Line_Count is Natural range 0 .. Schedule.Hearings_Per_Turn;

   type Refusal_Log is record
      Lines      : Line_Count := Max_Lines;
      --  that may still be written now
      Turn_Lines : Turn_Line_Count := 0;
      --  written in this turn
      Unwritten  : Natural := 0;
      --  rejections without a line of their own, not yet reported
      Last       : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  time of the last rejection
   end record;

   type Defence is record
      Arrivals   : Admission.Blocklists.History;
      --  since the kernel's queue was last empty
      Blocked    : Admission.Blocklists.List;
      Release    : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  when the oldest of them is released
      Unfiltered : Boolean := False;
      --  the kernel has refused it, as the log says
   end record;

   type Gate is record
      Allowed  : Admission.Networks.List;
      Token    : Admission.Authentication.Token;
      Table    : Admission.Pending_Connections.Table;
      Places   : Newcomer_Array;
      --  a connection waits here for its token line, or is kept while the end
      --  of a session prevents the decision
      Pause    : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  no connection is accepted before: the last accept has failed
      Rest     : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  the next turn does not begin before
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
