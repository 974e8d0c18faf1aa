--  SPDX-License-Identifier: GPL-3.0-or-later
--  A simulated cable that can be cut.

with Ada.Directories;
with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with GNAT.OS_Lib;
with Interfaces.C;      use Interfaces.C;

with Child_Processes;   use Child_Processes;
with Expectations;      use Expectations;
with Libc;

package body Network_Links is

   function Number (Process : int) return String is
     (Trim (Process'Image, Both));

   function Namespace_Of (Process : int) return String is
     ("destijl" & Number (Process));

   function Near_End_Of (Process : int) return String is
     ("dsh" & Number (Process));

   Name   : constant String := Namespace_Of (Libc.Getpid);
   Here   : constant String := Near_End_Of (Libc.Getpid);
   There  : constant String := "dst" & Number (Libc.Getpid);
   --  the process number keeps two runs on one machine apart

   Home : int := -1;
   --  the namespace to return to

   function Address (Process : int; Host : Natural) return String is
      --  1 and 2 of its net of four addresses; 0 is the net
      Places : constant := 64 * 200;
      --  nets, from 10.213.0.0 on, one by process number
      Place  : constant Natural := Natural (Process) mod Places;

      function Plain (Value : Natural) return String is
        (Trim (Value'Image, Both));
   begin
      return "10.213." & Plain (Place / 64) & "."
        & Plain (Place mod 64 * 4 + Host);
   end Address;

   function Supervisor_Side return String is (Address (Libc.Getpid, 1));
   function Monitor_Side return String is (Address (Libc.Getpid, 2));

   function Nowhere (Process : int) return String is
     ("unreachable " & Address (Process, 0) & "/30 metric 4096");
   --  The route that is left when the others are gone: no packet leaves by
   --  the machine's own network

   function Succeeds (Command : String) return Boolean is
      Tool    : Child;
      Options : Arguments := Words (Command);
      Program : constant String := Options.First_Element;
   begin
      Options.Delete_First;
      Tool.Start (Program, Options);
      return Tool.Exit_Status = 0;
   end Succeeds;

   procedure Run (Command : String) is
      --  Raises Failed unless it succeeds
   begin
      Check (Succeeds (Command), "failed: " & Command);
   end Run;

   procedure Run_There (Command : String) is
      --  The same at the monitor's end. Not by ip -n, which mounts a /sys of
      --  its own and fails where / is no mount point
      Done : Boolean;
   begin
      Enter (Name);
      Done := Succeeds (Command);
      Leave;
      Check (Done, "failed: " & Command);
   end Run_There;

   function Obstacle return String is
      --  Why no link can be made here; "" if it can
      use type GNAT.OS_Lib.String_Access;
      Tool : GNAT.OS_Lib.String_Access;
   begin
      if Libc.Geteuid /= 0 then
         return "only root can make a network namespace";
      end if;
      Tool := GNAT.OS_Lib.Locate_Exec_On_Path ("ip");
      if Tool = null then
         return "there is no ip command here (package iproute2)";
      end if;
      GNAT.OS_Lib.Free (Tool);
      if not Succeeds ("ip netns add " & Name & "t") then
         return "network namespaces are not allowed here";
      end if;
      Run ("ip netns del " & Name & "t");
      return "";
   end Obstacle;

   procedure Make (Object : in out Link) is
      Reason : constant String := Obstacle;
   begin
      if Reason /= "" then
         Skip (Reason);
      end if;
      Run ("ip netns add " & Name);
      Object.Made := True;
      Run ("ip link add " & Here & " type veth peer name " & There);
      Run ("ip link set " & There & " netns " & Name);
      Run ("ip addr add " & Supervisor_Side & "/30 dev " & Here);
      Run ("ip link set " & Here & " up");
      Run ("ip route add " & Nowhere (Libc.Getpid));
      Run_There ("ip addr add " & Monitor_Side & "/30 dev " & There);
      Run_There ("ip link set " & There & " up");
   end Make;

   function Namespace (Object : Link) return String is
     (if Object.Made then Name else "");

   procedure Change (Object : Link; How : Cut_Kind; Breaks : Boolean) is
      --  To mend what is not cut changes nothing

      function Set_Interface (Name : String) return String is
        ("ip link set " & Name & (if Breaks then " down" else " up"));

      function Set_Address (Address, Name : String) return String is
        ("ip addr " & (if Breaks then "del " else "replace ")
         & Address & "/30 dev " & Name);

      function Set_Station (Address, Name : String) return String is
        --  of this address: one that is not there
        (if Breaks
         then "ip neigh replace " & Address & " dev " & Name
           & " lladdr 02:00:00:00:00:99 nud permanent"
         else "ip neigh flush to " & Address & " dev " & Name
           & " nud permanent");

   begin
      Check (Object.Made, "no link to cut or mend");
      case How is
         when Cable_Pulled   =>
            Run_There (Set_Interface (There));
         when Monitor_Gone   =>
            Run_There (Set_Address (Monitor_Side, There));
         when Dropped_There  =>
            Run (Set_Station (Monitor_Side, Here));
         when Dropped_Here   =>
            Run_There (Set_Station (Supervisor_Side, There));
         when Interface_Down =>
            Run (Set_Interface (Here));
         when Address_Gone   =>
            Run (Set_Address (Supervisor_Side, Here));
         when Route_Gone     =>
            Run ("ip route " & (if Breaks then "del " else "replace ")
                 & Address (Libc.Getpid, 0) & "/30 dev " & Here
                 & " src " & Supervisor_Side);
      end case;
   end Change;

   procedure Cut (Object : in out Link; How : Cut_Kind := Cable_Pulled) is
   begin
      Change (Object, How, Breaks => True);
   end Cut;

   procedure Mend (Object : in out Link; How : Cut_Kind := Cable_Pulled) is
   begin
      Change (Object, How, Breaks => False);
   end Mend;

   procedure Enter (Namespace : String) is
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

   overriding procedure Finalize (Object : in out Link) is
   begin
      Object.Remove;
   end Finalize;

   procedure Remove (Object : in out Link) is
   begin
      if Object.Made then
         Object.Made := False;
         Remove_Left (Libc.Getpid);
      end if;
   end Remove;

   procedure Remove_Left (Process : int) is
      Unused : Boolean;
   begin
      if Ada.Directories.Exists ("/run/netns/" & Namespace_Of (Process)) then
         Unused := Succeeds ("ip link del " & Near_End_Of (Process));
         Unused := Succeeds ("ip route del " & Nowhere (Process));
         Unused := Succeeds ("ip netns del " & Namespace_Of (Process));
      end if;
   end Remove_Left;

end Network_Links;
