package org.u2sa.drivers.mavlink;

/** ADSB_VEHICLE, byte for byte by its definition: CRC_EXTRA 184, 38 bytes. */
public final class AdsbFrames {
  private static final int COORDS_ALTITUDE_HEADING_VELOCITY_NAME_CLIMB = 1 + 2 + 4 + 8 + 16 + 128;

  private AdsbFrames() {}

  /** The aircraft of GDL 90's example. */
  public static byte[] example() {
    return frame(COORDS_ALTITUDE_HEADING_VELOCITY_NAME_CLIMB, 449_070_800).from(1);
  }

  static MavlinkFrame frame(int flags, int latitude) {
    MavlinkFrame frame = new MavlinkFrame(246, 184, 38);
    frame.i32(0, 0xAB4549).i32(4, latitude).i32(8, -1_229_948_800).i32(12, 1_524_000);
    frame.i16(16, 4_500).i16(18, 6_328).i16(20, 33).i16(22, flags).i16(24, 1200);
    frame.i8(26, 0);
    for (int i = 0; i < "N825V".length(); i++) {
      frame.i8(27 + i, "N825V".charAt(i));
    }
    return frame.i8(36, 1).i8(37, 2);
  }
}
