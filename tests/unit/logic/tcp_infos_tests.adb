--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel tells of a connection.

with AUnit.Assertions;  use AUnit.Assertions;

with Interfaces;        use Interfaces;
with Monitor.Link;      use Monitor.Link;
with Unit_Runs; use Unit_Runs;

procedure Tcp_Infos_Tests is

   procedure Test_Extremes is
      Info : constant Tcp_Info :=
        (Unacked     => Unsigned_32'Last,
         Not_Sent    => Unsigned_32'Last,
         Last_Data   => Unsigned_32'Last,
         Last_Ack    => Unsigned_32'Last,
         Bytes_Acked => Unsigned_64'Last,
         others      => <>);
      S    : constant Sample := Sample_Of (Info, 232, 7);
   begin
      Assert (S.Unacknowledged = Natural'Last, "segments");
      Assert (S.Outstanding = Natural'Last, "bytes");
      Assert (S.Since_Heard = 2 ** 32 - 1, "time");
      Assert (S.Bytes_Acked = Byte_Count'Last, "acknowledged");
   end Test_Extremes;

   procedure Test_Layout is
      Info : Tcp_Info;
      --  offsets of tcpi_probes, tcpi_unacked, tcpi_last_data_recv,
      --  tcpi_last_ack_recv, tcpi_bytes_acked, tcpi_notsent_bytes,
      --  tcpi_snd_wnd
   begin
      Assert (Info.Probes'Position = 3, "probes");
      Assert (Info.Unacked'Position = 24, "unacked");
      Assert (Info.Last_Data'Position = 52, "last_data_recv");
      Assert (Info.Last_Ack'Position = 56, "last_ack_recv");
      Assert (Info.Bytes_Acked'Position = 120, "bytes_acked");
      Assert (Info.Not_Sent'Position = 144, "notsent_bytes");
      Assert (Info.Window'Position = 228, "snd_wnd");
      Assert (Info.Window'Position + 4 = Needed_Bytes, "needed");
   end Test_Layout;

   procedure Test_Sample is
      Info  : constant Tcp_Info :=
        (Unacked     => 2,
         Not_Sent    => 100,
         Window      => 2 ** 31,
         Probes      => 3,
         Last_Data   => 40,
         Last_Ack    => 30,
         Bytes_Acked => 5,
         others      => <>);
      Young : Tcp_Info := Info;
      S     : Sample   := Sample_Of (Info, 232, 1_000);
   begin
      Assert (S = (Now            => 1_000,
                   Known          => True,
                   Patience       => Milliseconds'Last,
                   Unacknowledged => 2,
                   Outstanding    => 102,
                   Window         => Natural'Last,
                   Probes         => 3,
                   Since_Heard    => 30,
                   Since_Data     => 40,
                   Bytes_Acked    => 5),
              "all of it");
      Young.Last_Data := 20;
      S := Sample_Of (Young, 256, 1_000);
      Assert (S.Since_Heard = 20, "data is a sign of life, too");
      S := Sample_Of (Info, 231, 1_000);
      Assert (S = (Now => 1_000, others => <>), "not enough");
   end Test_Sample;

begin
   Run_Test ("as in C", Test_Layout'Access);
   Run_Test ("a sample", Test_Sample'Access);
   Run_Test ("the largest numbers", Test_Extremes'Access);
end Tcp_Infos_Tests;
