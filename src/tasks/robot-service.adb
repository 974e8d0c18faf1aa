--  SPDX-License-Identifier: GPL-3.0-or-later

with Journal;
with Monitor.Mailboxes;
with Monitor.Notices;
with Monitor.Outbox;
with Monitor.Protocol;
with Options;
with Robot.Exchange;
with Robot.Line;
with Robot.Line_Status;
with Robot.Requests;
with Robot.Session;
with Trace;

package body Robot.Service with SPARK_Mode is

   use type Robot.Requests.Source;
   use type Robot.Requests.Verdict_Kind;
   use type Robot.Session.Mode_Kind;

   procedure Tell_Of (Note : Commands.Note_Kind; Empty, Gone : Boolean) is
      --  What the monitor and the log learn of Note. Empty: the robot's
      --  battery, when last asked. Gone: the device of its line
   begin
      case Note is
         when Commands.Nothing =>
            null;
         when Commands.Missed_Window =>
            Journal.Put
              (Options.Warning,
               "watchdog reload outside its window: the robot runs on");
         when Commands.Not_Running =>
            Journal.Put
              (Options.Warning, Monitor.Notices.Robot_Not_Running);
            Monitor.Outbox.Put
              (Monitor.Mailboxes.Told (Monitor.Notices.Robot_Not_Running));
         when Commands.Robot_Lost =>
            Journal.Put
              (Options.Warning,
               (if Gone then
                   "robot lost: the device of its line has gone"
                elsif Empty then Monitor.Notices.Robot_Lost_Empty
                else "robot lost: four failures in a row, its line is "
                  & "closed"));
            Monitor.Outbox.Put
              ((Kind   => Monitor.Mailboxes.Lost,
                Line   => Monitor.Protocol.Timed_Out,
                others => <>));
            if Empty then
               Monitor.Outbox.Put
                 (Monitor.Mailboxes.Told (Monitor.Notices.Robot_Lost_Empty));
            end if;
      end case;
   end Tell_Of;

   procedure Tell_Of_Start (Mode : Robot.Session.Mode_Kind) is
      --  The robot has begun to run: the periodic tasks look when they are due
   begin
      Robot.Line.Battery.Set;
      Robot.Line.Open_Com.Set;
      Journal.Put
        (Options.Info,
         (if Mode = Robot.Session.Started_With_Watchdog
          then "robot started with watchdog"
          else "robot started without watchdog"));
   end Tell_Of_Start;

   procedure Serve
     (Who    : Schedule.Task_Name;
      Result : out Commands.Outcome;
      Found  : out Boolean)
   is
      Item    : Robot.Requests.Job;
      Verdict : Robot.Requests.Verdict_Kind;
      Held    : Robot.Line_Status.Dialogue;
      Empty   : Boolean;
   begin
      Robot.Line.Grant.Take (Who, Item, Verdict, Held, Found);
      Result :=
        (Kind   =>
           (if Verdict = Robot.Requests.Late then Commands.Timed_Out
            else Commands.Refused),
         others => <>);
      if not Found then
         return;
      elsif Item.Order.Owed then
         Trace.Put (Trace.Take, Who, Item.Order.Number);
      end if;
      Empty := Held.Empty;
      if Verdict = Robot.Requests.Carry_Out then
         Robot.Exchange.Carry_Out (Who, Held, Item.Request, Result);
      end if;
      Robot.Line.Finish (Item, Held, Result);
      if Robot.Line_Status.Starts (Item, Result) then
         Tell_Of_Start (Held.State.Mode);
      end if;
      if Item.Order.Owed then
         Monitor.Outbox.Answer
           (Item.Order,
            Monitor.Protocol.Reply_To (Item.Order.Command.Name, Result));
      elsif Item.From = Robot.Requests.Battery
        and then Held.State.Mode /= Robot.Session.Not_Started
      then
         Monitor.Outbox.Put
           ((Kind   => Monitor.Mailboxes.Battery,
             Line   => Monitor.Protocol.Battery_Notice (Result),
             others => <>));
      end if;
      pragma Assert (not Item.Order.Owed);
      Tell_Of (Result.Note, Empty, Held.Gone);
   end Serve;

   procedure Serve (Who : Schedule.Task_Name) is
      Ignored_Result : Commands.Outcome;
      Ignored_Found  : Boolean;
   begin
      Serve (Who, Ignored_Result, Ignored_Found);
   end Serve;

end Robot.Service;
