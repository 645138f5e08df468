package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.world.World;

/** A host that sends what a board, a receiver and a compass understand, with any values. */
class HostileHostTest {
  private static final int MESSAGES = 20_000;
  private static final long STEP_MICROS = 5_000;
  private static final int UBX_CFG = 0x06;
  private static final int[] UBX_IDS = {0x00, 0x01, 0x08, 0x09, 0x24};
  private static final int[] UBX_LENGTHS = {20, 3, 8, 6, 13};

  private final IoioFirmware board =
      new IoioFirmware(
          IoioBoard.OTG, MiniMolle.in(World.at(new Geodetic(-81.05, 29.19, 0.0))).build());
  private final byte[] answers = new byte[8192];
  private long micros;

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void accept_wellFormedMessagesWithAnyValues_neverFails(long seed) {
    Random random = new Random(seed);
    int sessions = 0;
    for (int i = 0; i < MESSAGES; i++) {
      if (!board.isOpen()) {
        sessions++;
        board.open();
        send(uart(0, 6, 7));
        send(uart(1, 13, 14));
      }
      send(random.nextInt(3) == 0 ? toDevice(random) : toBoard(random));
      micros += STEP_MICROS;
      board.advance(micros);
      board.output(answers);
    }
    assertThat(sessions).isPositive();
  }

  private void send(byte[] bytes) {
    board.accept(bytes, 0, bytes.length);
  }

  private static byte[] bytes(int... octets) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (int octet : octets) {
      all.write(octet);
    }
    return all.toByteArray();
  }

  /** Opens a UART of 9600 baud. */
  private static byte[] uart(int number, int receive, int transmit) {
    return bytes(
        0x0D,
        number << 6 | 0x08,
        416 & 0xFF,
        416 >> 8,
        0x0F,
        transmit,
        number | 0xC0,
        0x0F,
        receive,
        number | 0x80);
  }

  private static byte[] toBoard(Random random) {
    int word = random.nextInt(1 << 16);
    int pin = random.nextInt(47);
    return switch (random.nextInt(6)) {
      case 0 -> bytes(0x08, pin, random.nextInt(9) | 0x80);
      case 1 -> bytes(0x09, random.nextInt(9) << 2 | random.nextInt(4), word & 0xFF, word >> 8);
      case 2 ->
          bytes(
              0x0A,
              random.nextInt(9) << 1 | random.nextInt(2) | random.nextInt(2) << 7,
              word & 0xFF,
              word >> 8);
      case 3 -> bytes(0x1B, random.nextInt(9), random.nextInt(8) << 3 | random.nextInt(4));
      case 4 -> bytes(0x1C, pin, random.nextInt(9) | 0x80);
      default -> bytes(0x04, pin << 2 | random.nextInt(2));
    };
  }

  /** A configuration of the receiver, or a command of the compass. */
  private static byte[] toDevice(Random random) {
    ByteArrayOutputStream device = new ByteArrayOutputStream();
    int uart = random.nextInt(2);
    if (uart == 0) {
      int kind = random.nextInt(UBX_IDS.length);
      byte[] frame = new byte[4 + UBX_LENGTHS[kind]];
      random.nextBytes(frame);
      frame[0] = UBX_CFG;
      frame[1] = (byte) UBX_IDS[kind];
      frame[2] = (byte) UBX_LENGTHS[kind];
      frame[3] = 0;
      frame[4] = kind == 0 ? 1 : frame[4]; // the UART's port
      int a = 0;
      int b = 0;
      device.writeBytes(bytes(0xB5, 0x62));
      device.writeBytes(frame);
      for (byte octet : frame) {
        a = a + octet & 0xFF;
        b = b + a & 0xFF;
      }
      device.writeBytes(bytes(a, b));
    } else {
      int[] commands = {0x02, 0x06, 0x09, 0x57, 0x83, 0x00};
      device.writeBytes(bytes(0xA4, commands[random.nextInt(commands.length)]));
      device.writeBytes(bytes(random.nextInt(256), random.nextInt(256), 0xA0));
    }
    byte[] content = device.toByteArray();
    ByteArrayOutputStream message = new ByteArrayOutputStream();
    message.writeBytes(bytes(0x0E, uart << 6 | content.length - 1));
    message.writeBytes(content);
    return message.toByteArray();
  }
}
