package org.u2sa.drivers.range;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Packets of a VLP-16, written from its manual and apart from the driver. */
public final class VelodynePackets {
  private static final int[] ELEVATIONS = {
    -15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15
  };

  /** What stands in a direction. */
  @FunctionalInterface
  public interface Scene {
    /** Range [m]; 0 without an echo. Azimuth is clockwise from ahead. */
    double rangeM(double azimuthDeg, double elevationDeg);
  }

  private VelodynePackets() {}

  /** Whole revolutions, each of 75 packets with 0.4° between blocks. */
  public static byte[] revolutions(int number, Scene scene) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (int packet = 0; packet < number * 75; packet++) {
      ByteBuffer bytes = ByteBuffer.allocate(1206).order(ByteOrder.LITTLE_ENDIAN);
      for (int block = 0; block < 12; block++) {
        int azimuth = (packet * 12 + block) % 900 * 40;
        bytes.put((byte) 0xFF).put((byte) 0xEE).putShort((short) azimuth);
        for (int channel = 0; channel < 32; channel++) {
          double degrees = azimuth / 100.0 + (channel < 16 ? 0.0 : 0.2);
          double rangeM = scene.rangeM(degrees, ELEVATIONS[channel % 16]);
          bytes.putShort((short) Math.round(rangeM / 0.002)).put((byte) 100);
        }
      }
      bytes.putInt(packet * 1327).put((byte) 0x37).put((byte) 0x22);
      all.writeBytes(bytes.array());
    }
    return all.toByteArray();
  }
}
