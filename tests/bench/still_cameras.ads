--  SPDX-License-Identifier: GPL-3.0-or-later
--  A camera in the network that sends one image again and again, as fast as
--  it is told: one that costs next to nothing itself.

package Still_Cameras is

   procedure Start (Path : String; Rate : Positive; Port : out Positive);
   --  Path: of a JPEG file. Rate: images a second. Serves one client, at
   --  http://127.0.0.1:Port/, until Stop or until it goes

   procedure Stop;

end Still_Cameras;
