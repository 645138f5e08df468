package org.u2sa.mavlink;

import java.util.zip.CRC32;

/**
 * MAVLink's CRC-32 of files and parameters: it has the polynomial of {@link CRC32}, but starts with
 * 0 and does not invert the result (PX4's crc32part, QGroundControl's QGC::crc32). Because CRCs are
 * linear, it equals the usual CRC of the bytes XOR that of as many zeros.
 */
public final class MavlinkCrc32 {
  private final CRC32 content = new CRC32();
  private final CRC32 zeros = new CRC32();

  /** Adds bytes. */
  public MavlinkCrc32 update(byte[] bytes) {
    content.update(bytes);
    zeros.update(new byte[bytes.length]);
    return this;
  }

  /** The checksum so far. */
  public int value() {
    return (int) (content.getValue() ^ zeros.getValue());
  }
}
