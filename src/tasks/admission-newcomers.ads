--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission of the monitor: th_server checks the address of each new client,
--  its token, and whether another monitor is in command.

with Ada.Real_Time;
with Admission.Authentication;
with Admission.Networks;
with Monitor.Sockets.Gate;
with Schedule;
with Texts;

package Admission.Newcomers with SPARK_Mode is

   type Gate is private;
   --  The pending connections and their state

   function Is_Consistent (G : Gate) return Boolean with Ghost;
   --  Invariant: a connection is pending only if its address is allowed, and
   --  entitled only if it has also sent the right line where one is required

   function New_Gate
     (Allowed : Admission.Networks.List;
      Token   : Admission.Authentication.Token) return Gate
   with Post => Is_Consistent (New_Gate'Result);
   --  No pending connection

   procedure Serve (G : in out Gate)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  One turn of th_server: waits for an event (new connection, data,
   --  time-out, end of a session), and handles a limited number of
   --  connections. Turns are at least a Newcomer_Interval apart, so a flood
   --  cannot take all the processor time

private

   subtype Place is Monitor.Sockets.Gate.Place;

   type Standing is
     (Free,
      Asked,      --  for its token
      Entitled);  --  to be admitted, or told why not, when no session is
                  --  being ended

   type Newcomer is record
      State  : Standing := Free;
      Line   : Monitor.Sockets.Socket := Monitor.Sockets.Nobody;
      From   : Admission.Networks.Socket_Address;
      Name   : Texts.Text;
      Came   : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      Reader : Admission.Authentication.Reader;
   end record;

   type Newcomer_Array is array (Place) of Newcomer;

   type Gate is record
      Allowed   : Admission.Networks.List;
      Token     : Admission.Authentication.Token;
      Places    : Newcomer_Array;
      Rest      : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  the next turn does not begin before
      Lines     : Natural range 0 .. Schedule.Refusals_Logged := 0;
      Lines_End : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  the number of rejections that may still be logged until then
      Unlogged  : Natural := 0;
      --  the others, not yet reported
   end record;

   function New_Gate
     (Allowed : Admission.Networks.List;
      Token   : Admission.Authentication.Token) return Gate
   is (Allowed => Allowed, Token => Token, others => <>);

   function Is_Consistent (G : Gate) return Boolean is
     (for all N of G.Places =>
        (if N.State /= Free then Admission.Networks.Admits (G.Allowed, N.From))
        and then
          (if N.State = Entitled and then G.Token.Length > 0 then
              Admission.Authentication.Is_Right (N.Reader, G.Token)));

end Admission.Newcomers;
