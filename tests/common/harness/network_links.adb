--  SPDX-License-Identifier: GPL-3.0-or-later
--  A simulated cable that can be cut.

with Ada.Directories;
with Interfaces.C;      use Interfaces.C;

with Child_Processes;   use Child_Processes;
with Expectations;      use Expectations;
with Libc;
with Plain_Numbers;     use Plain_Numbers;

package body Network_Links is

   function Namespace_Of (Process : int) return String is
     ("destijl" & Image (Integer (Process)));

   function Near_End_Of (Process : int) return String is
     ("dsh" & Image (Integer (Process)));

   function Namespace return String is (Namespace_Of (Libc.Getpid));

   Here  : constant String := Near_End_Of (Libc.Getpid);
   There : constant String := "dst" & Image (Integer (Libc.Getpid));
   --  the process number keeps two runs on one machine apart

   Home : int := -1;
   --  the namespace to return to

   function Address (Process : int; Host : Natural) return String is
      --  1 and 2 of its net of four addresses; 0 is the net
      Places : constant := 64 * 200;
      --  nets, from 10.213.0.0 on, one by process number
      Place  : constant Natural := Natural (Process) mod Places;
   begin
      return "10.213." & Image (Place / 64) & "."
        & Image (Place mod 64 * 4 + Host);
   end Address;

   function Supervisor_Side return String is (Address (Libc.Getpid, 1));
   function Monitor_Side return String is (Address (Libc.Getpid, 2));

   function Nowhere (Process : int) return String is
     ("unreachable " & Address (Process, 0) & "/30 metric 4096");
   --  The route that is left when the others are gone: no packet leaves by
   --  the machine's own network

   procedure Run (Command : String) is
      --  Raises Failed unless it succeeds
   begin
      Check (Status_Of (Command) = 0, "failed: " & Command);
   end Run;

   procedure Run_There (Command : String) is
      --  The same at the monitor's end. Not by ip -n, which mounts a /sys of
      --  its own and fails where / is no mount point
      Status : Integer;
   begin
      Enter;
      Status := Status_Of (Command);
      Leave;
      Check (Status = 0, "failed: " & Command);
   end Run_There;

   procedure Make (Object : in out Link) is
   begin
      if Libc.Geteuid /= 0 then
         Skip ("only root can make a network namespace");
      elsif Status_Of ("ip -V") /= 0 then
         Skip ("there is no ip command here (package iproute2)");
      elsif Status_Of ("ip netns add " & Namespace) /= 0 then
         Skip ("network namespaces are not allowed here");
      end if;
      Object.Made := True;
      Run ("ip link add " & Here & " type veth peer name " & There);
      Run ("ip link set " & There & " netns " & Namespace);
      Run ("ip addr add " & Supervisor_Side & "/30 dev " & Here);
      Run ("ip link set " & Here & " up");
      Run ("ip route add " & Nowhere (Libc.Getpid));
      Run_There ("ip addr add " & Monitor_Side & "/30 dev " & There);
      Run_There ("ip link set " & There & " up");
   end Make;

   procedure Cut (How : Cut_Kind := Cable_Pulled) is

      function Another_Station (Address, Name : String) return String is
        --  of this address: one that is not there
        ("ip neigh replace " & Address & " dev " & Name
         & " lladdr 02:00:00:00:00:99 nud permanent");

   begin
      case How is
         when Cable_Pulled   =>
            Run_There ("ip link set " & There & " down");
         when Monitor_Gone   =>
            Run_There ("ip addr del " & Monitor_Side & "/30 dev " & There);
         when Dropped_There  =>
            Run (Another_Station (Monitor_Side, Here));
         when Dropped_Here   =>
            Run_There (Another_Station (Supervisor_Side, There));
         when Interface_Down =>
            Run ("ip link set " & Here & " down");
         when Address_Gone   =>
            Run ("ip addr del " & Supervisor_Side & "/30 dev " & Here);
         when Route_Gone     =>
            Run ("ip route del " & Address (Libc.Getpid, 0) & "/30 dev " & Here
                 & " src " & Supervisor_Side);
      end case;
   end Cut;

   procedure Enter is
      File   : int;
      Result : int;
   begin
      Home := Libc.Open
        (To_C ("/proc/thread-self/ns/net"), Libc.O_Rdonly + Libc.O_Cloexec);
      File := Libc.Open
        (To_C ("/run/netns/" & Namespace), Libc.O_Rdonly + Libc.O_Cloexec);
      Result := Libc.Setns (File, Libc.Clone_Newnet);
      Libc.Close (File);
      Check (Result = 0, "cannot enter the namespace " & Namespace);
   end Enter;

   procedure Leave is
      Result : constant int := Libc.Setns (Home, Libc.Clone_Newnet);
   begin
      Libc.Close (Home);
      Check (Result = 0, "cannot leave the namespace");
   end Leave;

   procedure Remove_Left (Process : int) is
      Unused : Integer;
   begin
      if Ada.Directories.Exists ("/run/netns/" & Namespace_Of (Process)) then
         Unused := Status_Of ("ip link del " & Near_End_Of (Process));
         Unused := Status_Of ("ip route del " & Nowhere (Process));
         Unused := Status_Of ("ip netns del " & Namespace_Of (Process));
      end if;
   end Remove_Left;

   overriding procedure Finalize (Object : in out Link) is
   begin
      if Object.Made then
         Remove_Left (Libc.Getpid);
      end if;
   end Finalize;

end Network_Links;
