--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: what comes from the robot.

with Commands;
with Expectations;   use Expectations;
with Input_Readers;  use Input_Readers;
with Robot.Health;
with Robot.Protocol; use Robot.Protocol;
with Robot.Session;

package body Robot_Targets is

   use Bytes; use type Bytes.Byte;
   use type Robot.Session.Mode_Kind;
   use type Robot.Session.Step_Kind;

   procedure Read_Frame (F : Frame) is
      --  Against each command
      Answer : Reply;
   begin
      for Pending in Command_Kind loop
         Answer := Decode (F, Pending);
         Check
           (Is_Answer (Answer.Kind, Pending)
            or else Answer.Kind in Refused | Unknown_Command | Failed_Reply,
            "an answer to another command is taken");
      end loop;
   end Read_Frame;

   procedure Frames (Data : Byte_Array) is
      F     : Frame;
      Begun : Positive := 1;
      R     : Reader := (Size => Data'Length, Data => Data, Used => 0);
      Place : Integer;
      C     : Command;
   begin
      for I in Data'Range loop
         if Data (I) /= Terminator then
            Append (F, Data (I));
         else
            if I - Begun > Max_Frame then
               Check (Decode (F, Ping).Kind = Malformed,
                      "a frame that is too long is taken");
            else
               Check (F.Data (1 .. F.Length) = Data (Begun .. I - 1),
                      "a frame is not what came");
            end if;
            Read_Frame (F);
            F.Length := 0;
            Begun := I + 1;
         end if;
      end loop;

      --  any bytes at all, terminators among them
      F.Length := Natural'Min (Data'Length, Max_Frame);
      F.Data (1 .. F.Length) := Data (1 .. F.Length);
      Read_Frame (F);

      while not Is_Empty (R) loop
         Take (R, 0, Command_Kind'Pos (Command_Kind'Last), Place);
         C.Kind := Command_Kind'Val (Place);
         Take (R, Commands.Argument'First, Commands.Argument'Last, C.Value);
         Encode (C, F);
         F.Length := F.Length - 1;
         Read_Frame (F);
      end loop;
   end Frames;

   procedure Sessions (Data : Byte_Array) is
      R       : Reader := (Size => Data'Length, Data => Data, Used => 0);
      S       : Robot.Session.State;
      P       : Robot.Session.Progress;
      Wanted  : Commands.Request;
      Next    : Robot.Session.Step;
      Last    : Robot.Session.Step_Result;
      Choice  : Byte;
      Steps   : Natural;
      F       : Frame;

      procedure Answer is
         --  What the robot says to Next: a byte tells how many bytes arrive
         B        : Byte;
         Complete : Boolean := False;
      begin
         F.Length := 0;
         Last := (Ok => False, others => <>);
         Take (R, B);
         case Next.Kind is
            when Robot.Session.Exchange =>
               case B is
                  when 0 =>
                     null;  --  nothing in time
                  when Character'Pos ('O') | Character'Pos ('E')
                     | Character'Pos ('C')
                     | Character'Pos ('0') .. Character'Pos ('2') =>
                     --  a sound answer: text and checksum are the same
                     Append (F, B);
                     Append (F, B);
                     Complete := True;
                  when others =>
                     for I in 1 .. B loop
                        Take (R, B);
                        Complete := B = Terminator;
                        exit when Complete;
                        Append (F, B);
                     end loop;
               end case;
               if Complete then
                  Last.Reply := Decode (F, Next.Command.Kind);
                  Last.Text := Text_Of (F);
                  --  as Robot.Exchange has it
                  Last.Ok :=
                    (if Robot.Health.In_Step (S.Health)
                     then Last.Reply.Kind not in Failed_Reply
                     else Is_Answer (Last.Reply.Kind, Next.Command.Kind));
               end if;
            when others =>
               Last.Ok := B mod 2 = 0;
         end case;
      end Answer;

   begin
      while not Is_Empty (R) loop
         Take (R, Choice);
         Wanted.Kind := Commands.Request_Kind'Val
           (Natural (Choice)
            mod (Commands.Request_Kind'Pos
                   (Commands.Request_Kind'Last) + 1));
         Wanted.Command :=
           (case Choice / 16 mod 4 is
               when 0 => Commands.Forward,
               when 1 => Commands.Left,
               when 2 => (Commands.Move, 1),
               when others => Commands.Still);
         Robot.Session.Start_Request (S, Wanted, P);
         Steps := 0;
         loop
            --  the unit's own postconditions, which it does not check itself
            pragma Assert (Robot.Session.Is_Under_Way (S, P));
            Next := Robot.Session.Next_Step (S, P);
            pragma Assert (Robot.Session.Is_Allowed (S, P, Next));
            exit when Next.Kind = Robot.Session.Finish;
            Check (not Robot.Session.Sends_Movement (Next)
                   or else S.Mode /= Robot.Session.Not_Started,
                   "a movement before the start");
            if Robot.Session.Is_Sent (Next) then
               Check (S.Line_Open, "something is sent on a closed line");
               Encode (Next.Command, F);
            end if;
            Steps := Steps + 1;
            Check (Steps <= Robot.Session.Max_Steps, "a request does not end");
            Answer;
            Robot.Session.Continue_Request (S, P, Last);
         end loop;
         Check (Robot.Session.Is_Consistent (S), "an inconsistent state");
      end loop;
   end Sessions;

end Robot_Targets;
