--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission of the monitor: th_server checks the address of each new client,
--  its token, and whether another monitor is in command.

with Ada.Real_Time;
with Monitor.Sockets;
with Networks;
with Texts;

package Admission.Newcomers with SPARK_Mode is

   subtype Place is Positive range 1 .. 9;
   --  Of a connection: eight that are pending, and the one that comes

   type Standing is
     (Free,
      Asked,      --  for its token
      Entitled);  --  to be admitted, or told why not, when no session is
                  --  being ended

   type Newcomer is record
      State  : Standing := Free;
      Line   : Monitor.Sockets.Socket := Monitor.Sockets.Nobody;
      From   : Networks.Host := (others => 0);
      Name   : Texts.Text;
      Came   : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      Reader : Admission.Reader;
   end record;

   type Newcomer_Array is array (Place) of Newcomer;

   type Gate is record
      Allowed      : Networks.List;
      Token        : Admission.Token;
      Places       : Newcomer_Array;
      Rest         : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  the next turn does not begin before
      Refused      : Natural := 0;
      Interval_End : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  the rejections of an interval: the first of them are logged, the
      --  others counted at its end
   end record
   with Predicate =>
     (for all N of Places =>
        (if N.State /= Free then Networks.Admits (Allowed, N.From))
        and then
          (if N.State = Entitled and then Token.Length > 0 then
              Is_Right (N.Reader, Token)));
   --  The pending connections. One is pending only if its address is allowed,
   --  and entitled only if it has also sent the right line where one is
   --  required

   function New_Gate
     (Allowed : Networks.List;
      Token   : Admission.Token) return Gate
   is (Allowed => Allowed, Token => Token, others => <>);
   --  No pending connection

   procedure Serve (G : in out Gate);
   --  One turn of th_server: waits for an event (new connection, data,
   --  time-out, end of a session), and handles a limited number of
   --  connections. Turns are at least a Newcomer_Interval apart, so a flood
   --  cannot take all the processor time

   procedure Wake_Server;
   --  A session has ended

end Admission.Newcomers;
