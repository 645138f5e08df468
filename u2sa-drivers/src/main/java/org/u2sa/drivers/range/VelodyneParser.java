package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.device.port.PointScanner;
import org.u2sa.drivers.link.BinaryFramer;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.messages.frame.Point;

/**
 * Collects the data packets of a VLP-16 into revolutions (VLP-16 User Manual, 63-9243, chapter 9).
 * A packet has twelve blocks, each with an azimuth and two firings of sixteen lasers, and ends with
 * the product ID. A cloud is complete when the azimuth passes zero, straight ahead.
 */
final class VelodyneParser extends ByteParser<PointScanner.Cloud> {
  private static final int PACKET = 1206;
  private static final int BLOCKS = 12;
  private static final int BLOCK = 100;
  private static final int LASERS = 16;
  private static final int RETURN = 3; // bytes: distance, low byte first, and reflectivity
  private static final int FLAG = 0xEEFF; // flag of each block
  private static final int PRODUCT = 1205; // offset in the packet
  private static final int VLP16 = 0x22;
  private static final int CIRCLE = 36_000; // hundredths of a degree
  private static final double METRES_PER_UNIT = 0.002;
  private static final int MAX_POINTS = 120_000; // maximum, with two returns at 5 Hz
  private static final int[] ELEVATION_DEG = {
    -15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15
  };

  private final Packets packets = new Packets();
  private int lastAzimuth = -1; // azimuth of the latest block; negative before the first
  private List<Point> points = new ArrayList<>();
  private boolean isWhole; // whether the revolution was received from its beginning
  private long nowMicros;

  private final class Packets extends BinaryFramer {
    Packets() {
      super(PACKET, VelodyneParser.this::refuse);
    }

    @Override
    protected int lengthAt(int at, int available) {
      return available > 1 && unsigned16(at) != FLAG || unsigned8(at) != 0xFF ? NONE : PACKET;
    }

    @Override
    protected String fault(int at, int length) {
      for (int block = 0; block < BLOCKS; block++) {
        if (unsigned16(at + block * BLOCK) != FLAG || azimuth(at, block) >= CIRCLE) {
          return "not a data packet: block " + block + " without flag or azimuth";
        }
      }
      int product = unsigned8(at + PRODUCT);
      return product == VLP16 ? "" : "product " + product + ": expected a VLP-16, " + VLP16;
    }

    private int azimuth(int at, int block) {
      return unsigned16(at + block * BLOCK + 2);
    }

    @Override
    protected void take(int at, int length) {
      for (int block = 0; block < BLOCKS; block++) {
        int azimuth = azimuth(at, block);
        if (azimuth < lastAzimuth) {
          complete();
        }
        lastAzimuth = azimuth;
        int before =
            Math.min(
                block, BLOCKS - 2); // assume the rotation of the previous block for the last one
        int step = Math.floorMod(azimuth(at, before + 1) - azimuth(at, before), CIRCLE);
        firing(at + block * BLOCK + 4, azimuth);
        firing(at + block * BLOCK + 4 + LASERS * RETURN, azimuth + 0.5 * step);
      }
    }

    private void firing(int at, double hundredths) {
      double azimuthRad = Math.toRadians(hundredths / 100.0);
      for (int laser = 0; laser < LASERS; laser++) {
        double rangeM = METRES_PER_UNIT * unsigned16(at + laser * RETURN);
        if (rangeM > 0.0 && points.size() < MAX_POINTS) {
          double elevationRad = Math.toRadians(ELEVATION_DEG[laser]);
          double level = rangeM * Math.cos(elevationRad);
          points.add(
              Point.of(
                  level * Math.cos(azimuthRad),
                  -level * Math.sin(azimuthRad),
                  -rangeM * Math.sin(elevationRad)));
        }
      }
    }
  }

  private void complete() {
    if (isWhole) {
      found(new PointScanner.Cloud(nowMicros, List.copyOf(points)));
    }
    points = new ArrayList<>();
    isWhole = true;
  }

  @Override
  public void accept(byte[] bytes, int length, long now) {
    nowMicros = now;
    packets.accept(bytes, length);
  }

  @Override
  public void reset() {
    packets.reset();
    lastAzimuth = -1;
    points = new ArrayList<>();
    isWhole = false;
  }
}
