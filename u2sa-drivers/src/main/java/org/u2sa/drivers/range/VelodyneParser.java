package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.PointScanner;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.messages.frame.Point;

/**
 * Collects the data packets of a VLP-16 into revolutions (VLP-16 User Manual, 63-9243, chapter 9).
 * A packet has twelve blocks with an azimuth and two firings of sixteen lasers each, and ends with
 * the product's number. A cloud is complete when the azimuth passes zero, its y axis.
 */
final class VelodyneParser implements ByteParser<PointScanner.Cloud> {
  private static final int PACKET = 1206;
  private static final int BLOCKS = 12;
  private static final int BLOCK = 100;
  private static final int LASERS = 16;
  private static final int RETURN = 3; // bytes: distance, low byte first, and reflectivity
  private static final int PRODUCT = 1205; // its place in the packet
  private static final int VLP16 = 0x22;
  private static final int CIRCLE = 36_000; // hundredths of a degree
  private static final double METRES_PER_UNIT = 0.002;
  private static final int MAX_POINTS = 120_000; // of two returns at 5 Hz
  private static final int[] ELEVATION_DEG = {
    -15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15
  };

  private final byte[] packet = new byte[PACKET];
  private int count;
  private int lastAzimuth = -1; // of the latest block; negative before the first
  private List<Point> points = new ArrayList<>();
  private boolean isWhole; // whether the revolution was seen from its beginning
  private Optional<PointScanner.Cloud> latest = Optional.empty();
  private long refused;
  private String lastRefusal = "";

  @Override
  public void accept(byte[] bytes, int length, long nowMicros) {
    for (int i = 0; i < length; i++) {
      packet[count++] = bytes[i];
      if (count == PACKET) {
        count = 0;
        if (isPacket()) {
          read(nowMicros);
        } else {
          resynchronise();
        }
      }
    }
  }

  private boolean isPacket() {
    boolean is = (packet[PRODUCT] & 0xFF) == VLP16;
    for (int block = 0; block < BLOCKS; block++) {
      is &= isBlock(block * BLOCK);
    }
    return is;
  }

  private boolean isBlock(int at) {
    return packet[at] == (byte) 0xFF && packet[at + 1] == (byte) 0xEE;
  }

  /** Keeps what may be the beginning of a packet. */
  private void resynchronise() {
    refused++;
    lastRefusal = "not a data packet of a VLP-16";
    int from = 1;
    while (from < PACKET - 1 && !isBlock(from)) {
      from++;
    }
    if (from < PACKET - 1) {
      count = PACKET - from;
      System.arraycopy(packet, from, packet, 0, count);
    }
  }

  private void read(long nowMicros) {
    for (int block = 0; block < BLOCKS; block++) {
      int azimuth = azimuth(block);
      if (azimuth >= CIRCLE) {
        refused++;
        lastRefusal = "azimuth " + azimuth + " is outside 0…35999 hundredths of a degree";
        return;
      }
      if (azimuth < lastAzimuth) {
        if (isWhole) {
          latest = Optional.of(new PointScanner.Cloud(nowMicros, List.copyOf(points)));
        }
        points = new ArrayList<>();
        isWhole = true;
      }
      lastAzimuth = azimuth;
      add(block, azimuth);
    }
  }

  private int azimuth(int block) {
    return word(block * BLOCK + 2);
  }

  private int word(int at) {
    return packet[at] & 0xFF | (packet[at + 1] & 0xFF) << 8;
  }

  private void add(int block, int azimuth) {
    int before = Math.min(block, BLOCKS - 2); // the last block turns as the one before it
    int stepped = Math.floorMod(azimuth(before + 1) - azimuth(before), CIRCLE);
    for (int firing = 0; firing < 2; firing++) {
      double azimuthRad = Math.toRadians((azimuth + 0.5 * firing * stepped) / 100.0);
      for (int laser = 0; laser < LASERS; laser++) {
        int at = block * BLOCK + 4 + (firing * LASERS + laser) * RETURN;
        double rangeM = METRES_PER_UNIT * word(at);
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

  @Override
  public void reset() {
    count = 0;
    lastAzimuth = -1;
    points = new ArrayList<>();
    isWhole = false;
  }

  @Override
  public Optional<PointScanner.Cloud> latest() {
    return latest;
  }

  @Override
  public long refused() {
    return refused;
  }

  @Override
  public String lastRefusal() {
    return lastRefusal;
  }
}
