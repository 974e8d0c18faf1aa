--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Link with SPARK_Mode is

   procedure Append (Line : in out Texts.Text; Why : Cause) is
   begin
      case Why is
         when Present          =>
            null;
         when Supervisor_Stops =>
            Texts.Append (Line, "the supervisor is stopping");
         when Vanished         =>
            Texts.Append
              (Line, "it vanished, nothing has been acknowledged for ");
            Append_Seconds (Line, Vanished_After);
         when Unreachable      =>
            Texts.Append
              (Line, "it cannot be reached, nothing could be sent for ");
            Append_Seconds (Line, Vanished_After);
            Texts.Append (Line, ": no link, address or route");
         when Silent           =>
            Texts.Append
              (Line, "its program has been silent for longer than it promised "
               & "(LIVE), or --monitor-silence allows");
         when Stalled          =>
            Texts.Append (Line, "it has taken nothing for ");
            Append_Seconds (Line, Stalled_After);
         when No_Sign_Of_Life  =>
            Texts.Append (Line, "it vanished, no sign of life for ");
            Append_Seconds (Line, Vanished_After);
         when Reset_By_Peer    =>
            Texts.Append (Line, "connection reset");
         when Closed_By_Peer   =>
            Texts.Append (Line, "connection closed");
      end case;
   end Append;

   procedure Append_Seconds (Line : in out Texts.Text; Span : Milliseconds) is
   begin
      Texts.Append (Line, Integer (Span / 1_000));
      Texts.Append (Line, " s");
   end Append_Seconds;

end Monitor.Link;
