--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Link with SPARK_Mode is

   procedure Judge (S : in out State; X : Sample; V : out Verdict) is
      Progress : constant Boolean := Is_Progress (S, X);
   begin
      if Progress or else not S.Waiting or else not Is_Due (X) then
         S.Waiting_Since := X.Now;
      end if;
      if Progress or else not S.Holding or else X.Outstanding = 0 then
         S.Holding_Since := X.Now;
      end if;
      S.Waiting := Is_Due (X);
      S.Holding := X.Outstanding > 0;
      S.Acked   := X.Bytes_Acked;
      V := Verdict_On (S, X);
   end Judge;

   procedure Start (S : out State; Now : Milliseconds) is
   begin
      S := (Watched_Since => Now,
            Waiting       => False,
            Waiting_Since => Now,
            Holding       => False,
            Holding_Since => Now,
            Acked         => 0);
   end Start;

   procedure Append (Line : in out Texts.Text; Why : Cause) is
   begin
      case Why is
         when Nothing           =>
            null;
         when Supervisor_Stops  =>
            Texts.Append (Line, "the supervisor is stopping");
         when Monitor_Vanished  =>
            Texts.Append
              (Line, "it vanished, nothing has been acknowledged for ");
            Append_Seconds (Line, Vanished_After);
         when Monitor_Unreachable =>
            Texts.Append
              (Line, "it cannot be reached, nothing could be sent for ");
            Append_Seconds (Line, Vanished_After);
            Texts.Append (Line, ": no link, address or route");
         when Monitor_Silent    =>
            Texts.Append
              (Line, "its program has been silent for longer than it promised "
               & "(LIVE), or --monitor-silence allows");
         when Monitor_Stalled   =>
            Texts.Append (Line, "it has taken nothing for ");
            Append_Seconds (Line, Stalled_After);
         when Silence           =>
            Texts.Append (Line, "it vanished, no sign of life for ");
            Append_Seconds (Line, Vanished_After);
         when Connection_Reset  =>
            Texts.Append (Line, "connection reset");
         when Connection_Closed =>
            Texts.Append (Line, "connection closed");
      end case;
   end Append;

   procedure Append_Seconds (Line : in out Texts.Text; Span : Milliseconds) is
   begin
      Texts.Append (Line, Integer (Span / 1_000));
      Texts.Append (Line, " s");
   end Append_Seconds;

end Monitor.Link;
