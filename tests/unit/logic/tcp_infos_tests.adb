--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel tells of a connection.

with AUnit.Assertions;  use AUnit.Assertions;

with Interfaces;        use Interfaces;
with Monitor.Link;      use Monitor.Link;
with Unit_Runs; use Unit_Runs;

procedure Tcp_Infos_Tests is

   procedure Test_Extremes is
      S : constant Sample :=
        Sample_Of ((others => Unsigned_32'Last), Needed_Bytes, 7);
   begin
      Assert (S.Unacknowledged = 2 ** 32 - 1, "segments");
      Assert (S.Outstanding = 2 ** 33 - 2, "bytes");
      Assert (S.Probes = 255, "probes");
      Assert (S.Since_Heard = 2 ** 32 - 1, "time");
      Assert (S.Bytes_Acked = 2 ** 64 - 1, "acknowledged");
   end Test_Extremes;

   procedure Test_Sample is
      --  Offsets of tcpi_probes, tcpi_unacked, tcpi_last_data_recv,
      --  tcpi_last_ack_recv, tcpi_bytes_acked, tcpi_notsent_bytes and
      --  tcpi_snd_wnd
      Info : Tcp_Info :=
        (0 / 4 + 1   => 3 * 2 ** 24 + 16#0A_0B_0C#,
         24 / 4 + 1  => 2,
         52 / 4 + 1  => 40,
         56 / 4 + 1  => 30,
         120 / 4 + 1 => 5,
         124 / 4 + 1 => 1,
         144 / 4 + 1 => 100,
         228 / 4 + 1 => 2 ** 31,
         others      => 16#5555#);
      S    : Sample   := Sample_Of (Info, 232, 1_000);
   begin
      Assert (S = (Now            => 1_000,
                   Known          => True,
                   Patience       => Milliseconds'Last,
                   Unacknowledged => 2,
                   Outstanding    => 102,
                   Window         => 2 ** 31,
                   Probes         => 3,
                   Since_Heard    => 30,
                   Since_Data     => 40,
                   Bytes_Acked    => 2 ** 32 + 5),
              "all of it");
      Info (52 / 4 + 1) := 20;
      S := Sample_Of (Info, 256, 1_000);
      Assert (S.Since_Heard = 20, "data is a sign of life, too");
      S := Sample_Of (Info, 231, 1_000);
      Assert (S = (Now => 1_000, others => <>), "not enough");
   end Test_Sample;

begin
   Run_Test ("a sample", Test_Sample'Access);
   Run_Test ("the largest numbers", Test_Extremes'Access);
end Tcp_Infos_Tests;
