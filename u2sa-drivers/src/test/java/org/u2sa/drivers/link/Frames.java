package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;

import io.dronefleet.mavlink.MavlinkDialect;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** Frames of random content under checksums that are right. */
final class Frames {
  private static final MavlinkDialect DIALECT = new ArdupilotmegaDialect();
  private static final int XMODEM = 0x1021;
  private static final List<String> FIELDS =
      List.of(
          "",
          "0",
          "1",
          "-1",
          "1e300",
          "-1e300",
          "1e-300",
          "NaN",
          "Infinity",
          "999999999999",
          "-0",
          "4807.038",
          "-12.5",
          "123519",
          "N",
          "S",
          "E",
          "A",
          "V",
          "M",
          "W",
          "x",
          "179.9",
          "360");

  private Frames() {}

  /** Of any length up to that of the message, which MAVLink 2 fills with zeros. */
  static byte[] mavlink(Random random, int messageId, int longest) {
    byte[] payload = bytes(random, 1 + random.nextInt(longest));
    if (random.nextInt(3) == 0) { // else most random floats are absurd
      floats(random, payload);
    }
    Class<?> type = DIALECT.resolve(messageId);
    int crc = type.getAnnotation(MavlinkMessageInfo.class).crc();
    return MavlinkPacket.createUnsignedMavlink2Packet(0, 7, 1, messageId, crc, payload)
        .getRawBytes();
  }

  private static void floats(Random random, byte[] payload) {
    ByteBuffer buffer = ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN);
    float[] values = {0.0f, 1.0f, -1.5f, 1e30f, Float.NaN, Float.NEGATIVE_INFINITY, 1e16f};
    for (int at = 0; at + 4 <= payload.length; at += 4) {
      buffer.putFloat(at, values[random.nextInt(values.length)]);
    }
  }

  /** OBSTACLE_DISTANCE about the vehicle's axes, the only ones that a scan can have. */
  static byte[] obstacles(Random random) {
    byte[] payload = bytes(random, 167);
    payload[166] = 12; // MAV_FRAME_BODY_FRD
    if (random.nextInt(4) != 0) {
      ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN).putFloat(158, 5.0f).putFloat(162, 0);
    }
    return MavlinkPacket.createUnsignedMavlink2Packet(0, 7, 1, 330, 23, payload).getRawBytes();
  }

  /** A sentence with up to three of its fields replaced. */
  static byte[] nmea(Random random, String sentence) {
    String[] fields = sentence.split(",", -1);
    for (int changes = random.nextInt(4); changes > 0 && fields.length > 1; changes--) {
      fields[1 + random.nextInt(fields.length - 1)] = FIELDS.get(random.nextInt(FIELDS.size()));
    }
    String text = random.nextInt(8) == 0 ? anyNmea(random, fields[0]) : String.join(",", fields);
    int sum = 0;
    for (int i = 0; i < text.length(); i++) {
      sum ^= text.charAt(i);
    }
    return String.format(Locale.ROOT, "$%s*%02X\r\n", text, sum).getBytes(US_ASCII);
  }

  /** Any printable characters but those that end a sentence, half of them after a known name. */
  private static String anyNmea(Random random, String name) {
    StringBuilder text = new StringBuilder(random.nextBoolean() ? name : "");
    for (int left = random.nextInt(80); left > 0; left--) {
      char any = (char) (' ' + random.nextInt('~' - ' '));
      text.append(random.nextInt(4) == 0 || any == '*' || any == '$' || any == '!' ? ',' : any);
    }
    return text.toString();
  }

  /** UBX: Fletcher's checksum (u-blox M8 protocol, 32.4). Most numbers are possible ones. */
  static byte[] ubx(Random random, int id, int length) {
    byte[] frame = bytes(random, length + 8);
    ByteBuffer numbers = ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
    for (int at = 6; at + 4 <= length + 6; at += 4) {
      if (random.nextInt(8) != 0) {
        numbers.putInt(at, random.nextInt(2_000) - 1_000);
      }
    }
    int status = id == 0x07 ? 26 : id == 0x06 ? 16 : 10; // offset of fix type and flags
    if (random.nextInt(8) != 0) {
      numbers.put(status, (byte) 3).put(status + 1, (byte) 1);
    }
    if (id != 0x07) {
      numbers.putInt(6, 1_000); // of one time of week, as parts of one epoch have it
    }
    frame[0] = (byte) 0xb5;
    frame[1] = 0x62;
    frame[2] = 0x01;
    frame[3] = (byte) id;
    frame[4] = (byte) length;
    frame[5] = 0;
    int a = 0;
    int b = 0;
    for (int i = 2; i < length + 6; i++) {
      a = a + frame[i] & 0xff;
      b = b + a & 0xff;
    }
    frame[length + 6] = (byte) a;
    frame[length + 7] = (byte) b;
    return frame;
  }

  /** A traffic report (GDL 90 Data Interface Specification, 2.2.3 and 3.5). */
  static byte[] gdl90(Random random) {
    byte[] report = bytes(random, 28);
    report[0] = 20;
    int crc = 0;
    for (byte each : report) {
      int high = crc & 0xFF00;
      for (int bit = 0; bit < 8; bit++) {
        high = (high & 0x8000) == 0 ? high << 1 : high << 1 ^ XMODEM;
      }
      crc = (high ^ crc << 8 ^ each & 0xFF) & 0xFFFF;
    }
    ByteArrayOutputStream frame = new ByteArrayOutputStream();
    frame.write(0x7E);
    for (byte each : joined(report, new byte[] {(byte) crc, (byte) (crc >> 8)})) {
      boolean isEscaped = each == 0x7E || each == 0x7D;
      frame.writeBytes(isEscaped ? new byte[] {0x7D, (byte) (each ^ 0x20)} : new byte[] {each});
    }
    frame.write(0x7E);
    return frame.toByteArray();
  }

  /** COMM_GET_VALUES of a VESC. */
  static byte[] vesc(Random random) {
    byte[] payload = bytes(random, 60);
    payload[0] = 4;
    int crc = xmodem(payload);
    byte[] end = {(byte) (crc >> 8), (byte) crc, 3};
    return joined(joined(new byte[] {2, (byte) payload.length}, payload), end);
  }

  /** The answer of a RoboClaw to a request: what the command returns, or an acknowledgement. */
  static byte[] roboClaw(Random random, byte[] request) {
    int length = request[1] == 78 ? 8 : request[1] == 24 ? 2 : 0;
    if (length == 0) {
      return new byte[] {(byte) 0xFF};
    }
    byte[] data = bytes(random, length);
    int crc = xmodem(joined(new byte[] {request[0], request[1]}, data));
    return joined(data, new byte[] {(byte) (crc >> 8), (byte) crc});
  }

  static byte[] ping(Random random, int id, int length) {
    ByteBuffer message = ByteBuffer.wrap(bytes(random, 10 + length)).order(ByteOrder.LITTLE_ENDIAN);
    message.put(0, (byte) 'B').put(1, (byte) 'R');
    message.putShort(2, (short) length).putShort(4, (short) id);
    int sum = 0;
    for (int i = 0; i < 8 + length; i++) {
      sum += message.get(i) & 0xFF;
    }
    return message.putShort(8 + length, (short) sum).array();
  }

  /** A pinging answer of a Ping360, with as many samples as it says. */
  static byte[] ping360(Random random) {
    int samples = random.nextInt(50);
    byte[] frame = ping(random, 2300, 14 + samples);
    ByteBuffer message = ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
    message.putShort(10, (short) random.nextInt(400)).putShort(20, (short) samples);
    int sum = 0;
    for (int i = 0; i < frame.length - 2; i++) {
      sum += frame[i] & 0xFF;
    }
    return message.putShort(frame.length - 2, (short) sum).array();
  }

  /** A Hokuyo's answer to a request, with parameters that no laser has. */
  static byte[] scip(Random random, String request) {
    StringBuilder answer = new StringBuilder(request).append('\n');
    boolean isScan = request.startsWith("MD");
    answer.append(scipSum(isScan ? "99" : "00")).append('\n');
    if (request.equals("PP")) {
      int first = random.nextInt(10);
      int[] values = {random.nextInt(), random.nextInt(), 1 + random.nextInt(8192), first};
      String[] names = {"DMIN", "DMAX", "ARES", "AMIN"};
      for (int i = 0; i < names.length; i++) {
        answer.append(scipParameter(names[i] + ":" + Math.abs(values[i] % 1_000_000_000)));
      }
      answer.append(scipParameter("AMAX:" + (first + random.nextInt(20))));
      answer.append(scipParameter("AFRT:" + random.nextInt(1_000_000_000)));
      answer.append(scipParameter("SCAN:" + random.nextInt(3)));
    } else if (isScan) {
      int steps =
          Integer.parseInt(request.substring(6, 10)) - Integer.parseInt(request.substring(2, 6));
      StringBuilder data = new StringBuilder();
      for (int i = 0; i < 3 * (steps + 1); i++) {
        data.append((char) (0x30 + random.nextInt(0x40)));
      }
      answer.append(scipSum("0000")).append('\n');
      for (int at = 0; at < data.length(); at += 64) {
        answer.append(scipSum(data.substring(at, Math.min(data.length(), at + 64)))).append('\n');
      }
    }
    return answer.append('\n').toString().getBytes(US_ASCII);
  }

  private static String scipParameter(String text) {
    int sum = text.chars().sum();
    return text + ";" + (char) ((sum & 0x3F) + 0x30) + "\n";
  }

  private static String scipSum(String text) {
    return text + (char) ((text.chars().sum() & 0x3F) + 0x30);
  }

  /** A report of a Water Linked DVL with its CRC-8. */
  static byte[] waterLinked(Random random) {
    StringBuilder text = new StringBuilder("wrz");
    for (int i = 0; i < 3; i++) {
      text.append(',').append(FIELDS.get(random.nextInt(FIELDS.size())));
    }
    text.append(",y,0.2,0.1,0;0;0;0,7,1,12,0");
    int crc = 0;
    for (byte each : text.toString().getBytes(US_ASCII)) {
      crc ^= each & 0xFF;
      for (int bit = 0; bit < 8; bit++) {
        crc = ((crc & 0x80) == 0 ? crc << 1 : crc << 1 ^ 0x07) & 0xFF;
      }
    }
    return String.format(Locale.ROOT, "%s*%02x\r\n", text, crc).getBytes(US_ASCII);
  }

  /** A measurement of an RPLIDAR whose check bits are right. */
  static byte[] rplidar(Random random) {
    byte[] node = bytes(random, 5);
    node[0] = (byte) (node[0] & ~3 | (random.nextInt(8) == 0 ? 1 : 2));
    int angle = random.nextInt(360 * 64);
    node[1] = (byte) (angle << 1 | 1);
    node[2] = (byte) (angle >> 7);
    return node;
  }

  private static int xmodem(byte[] bytes) {
    int crc = 0;
    for (byte each : bytes) {
      crc ^= (each & 0xFF) << 8;
      for (int bit = 0; bit < 8; bit++) {
        crc = ((crc & 0x8000) == 0 ? crc << 1 : crc << 1 ^ XMODEM) & 0xFFFF;
      }
    }
    return crc;
  }

  private static byte[] bytes(Random random, int length) {
    byte[] bytes = new byte[length];
    random.nextBytes(bytes);
    return bytes;
  }

  private static byte[] joined(byte[] first, byte[] second) {
    return ByteBuffer.allocate(first.length + second.length).put(first).put(second).array();
  }
}
