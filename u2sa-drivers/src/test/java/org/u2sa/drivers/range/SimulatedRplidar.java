package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.LongSupplier;
import org.u2sa.drivers.link.MemoryLink;

/**
 * An RPLIDAR A1, byte for byte as Slamtec's LR001 says: idle, scanning, stopped to protect itself.
 * Turns ten times a second, one measurement a degree.
 */
final class SimulatedRplidar {
  private static final int NODES_PER_S = 3600;

  private final MemoryLink link;
  private final LongSupplier clock;
  private final DoubleUnaryOperator world; // clockwise degrees -> metres
  private boolean scanning;
  private long beganMicros;
  private long sent;
  private int status;
  private boolean mute;
  private int dropEach; // each so manieth byte is lost; 0: none
  private long bytes;
  private int resets;
  private boolean hasBoard; // an A2 on its USB adapter
  private int motorWidth;
  private final List<String> motorRequests = new ArrayList<>();

  SimulatedRplidar(MemoryLink link, LongSupplier clock, DoubleUnaryOperator world) {
    this.link = link;
    this.clock = clock;
    this.world = world;
    link.with(this::accept).producing(this::produce);
  }

  void status(int newStatus) {
    status = newStatus;
    scanning &= newStatus != 2;
  }

  void mute(boolean isMute) {
    mute = isMute;
  }

  void dropEach(int count) {
    dropEach = count;
  }

  /** An A2, whose motor stands until the adapter's board is told to run it. */
  void withMotorBoard() {
    hasBoard = true;
  }

  /** All that was said to the board, in hexadecimal digits. */
  List<String> motorRequests() {
    return motorRequests;
  }

  boolean isScanning() {
    return scanning;
  }

  int resets() {
    return resets;
  }

  private void accept(byte[] request) {
    if ((request[0] & 0xFF) != 0xA5) {
      return;
    }
    switch (request[1]) {
      case 0x50:
        say(0xA5, 0x5A, 0x14, 0x00, 0x00, 0x00, 0x04);
        say(hasBoard ? 0x28 : 0x18, 29, 1, 7);
        say(new byte[16]);
        break;
      case (byte) 0xFF:
        if (hasBoard) {
          say(0xA5, 0x5A, 0x04, 0x00, 0x00, 0x00, 0xFF);
          say(1, 0, 0, 0);
        }
        break;
      case (byte) 0xF0:
        motorRequests.add(HexFormat.of().formatHex(request));
        motorWidth = hasBoard ? request[3] & 0xFF | (request[4] & 0xFF) << 8 : 0;
        break;
      case 0x25:
        produce(); // what is on its way still comes
        scanning = false;
        break;
      case 0x40:
        scanning = false;
        status = 0;
        resets++;
        say("RP LIDAR System.\r\nFirmware Ver 1.29, HW Ver 7\r\nModel: 18\r\n".getBytes());
        break;
      case 0x52:
        say(0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06);
        say(status, 0x03, 0x80);
        break;
      case 0x20:
        if (status != 2) {
          say(0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81);
          scanning = true;
          beganMicros = clock.getAsLong();
          sent = 0;
        }
        break;
      default:
        break;
    }
  }

  private void produce() {
    long due = (clock.getAsLong() - beganMicros) * NODES_PER_S / 1_000_000;
    if (hasBoard && motorWidth == 0) {
      sent = due; // a motor that stands: nothing is measured
    }
    while (scanning && sent < due) {
      int degree = (int) (sent++ % 360);
      say(node(degree == 0, 15, degree, world.applyAsDouble(degree)));
    }
  }

  static byte[] node(boolean starts, int quality, double degrees, double metres) {
    int angle = (int) Math.round(degrees * 64.0);
    int distance = (int) Math.round(metres * 4000.0);
    return new byte[] {
      (byte) (quality << 2 | (starts ? 0b01 : 0b10)),
      (byte) (angle << 1 | 1),
      (byte) (angle >> 7),
      (byte) distance,
      (byte) (distance >> 8)
    };
  }

  private void say(int... unsigned) {
    byte[] said = new byte[unsigned.length];
    for (int i = 0; i < said.length; i++) {
      said[i] = (byte) unsigned[i];
    }
    say(said);
  }

  private void say(byte[] said) {
    for (byte each : said) {
      bytes++;
      if (!mute && (dropEach == 0 || bytes % dropEach != 0)) {
        link.fromDevice(each);
      }
    }
  }
}
