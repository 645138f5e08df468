package org.u2sa.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Decodes bytes of pymavlink 2.4.50: whole, cut, turned and in noise. */
class MavlinkStreamTest {
  private static final byte[] HEARTBEAT = hex("fd090000000101000000040000000a038104035b77");
  private static final byte[] ATTITUDE =
      hex("fd1c00000001011e000039300000cdcccc3dcdcc4cbe0000c0bf0ad7233c0ad7a33c8fc2f53c2e83");
  private static final byte[] ATTITUDE_1 =
      hex("fe1c0001011e39300000cdcccc3dcdcc4cbe0000c0bf0ad7233c0ad7a33c8fc2f53cae1e");
  private static final byte[] ATTITUDE_SIGNED =
      hex(
          "fd1c01000001011e000039300000cdcccc3dcdcc4cbe0000c0bf0ad7233c0ad7a33c8fc2f53c7139"
              + "01010000000000874daef46e9d");
  private static final byte[] POSITION =
      hex("fd1c0000000101210000393000004c52401c44f41705a4720700102700006400c80032007869261e");

  private final MavlinkStream stream = new MavlinkStream(255, 191);
  private final List<MavlinkStream.Received> heard = new ArrayList<>();

  private static byte[] hex(String text) {
    byte[] bytes = new BigInteger("01" + text, 16).toByteArray();
    return Arrays.copyOfRange(bytes, 1, bytes.length);
  }

  private void say(byte... bytes) {
    stream.accept(bytes, bytes.length, heard::add);
  }

  @Test
  void accept_versionTwo_isRead() {
    say(HEARTBEAT);
    say(ATTITUDE);
    say(POSITION);
    assertThat(heard).hasSize(3);
    assertThat(heard.get(0).systemId()).isEqualTo(1);
    Heartbeat heartbeat = (Heartbeat) heard.get(0).payload();
    assertThat(heartbeat.autopilot().entry()).isEqualTo(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA);
    assertThat(((Attitude) heard.get(1).payload()).yaw()).isEqualTo(-1.5f);
    GlobalPositionInt position = (GlobalPositionInt) heard.get(2).payload();
    assertThat(position.lat()).isEqualTo(473977420);
    assertThat(position.vz()).isEqualTo(50);
    assertThat(stream.malformed()).isZero();
  }

  @Test
  void accept_versionOneAndSigned_areReadToo() {
    say(ATTITUDE_1);
    say(ATTITUDE_SIGNED);
    say(ATTITUDE);
    assertThat(heard).hasSize(3);
    assertThat(heard)
        .allSatisfy(each -> assertThat(((Attitude) each.payload()).roll()).isEqualTo(0.1f));
  }

  @Test
  void accept_unknownMessage_isPassedOver() {
    byte[] unknown = ATTITUDE.clone();
    unknown[8] = (byte) 0xC3; // message ID 49950
    say(unknown);
    say(ATTITUDE);
    assertThat(heard).hasSize(1);
    assertThat(stream.malformed()).isZero();
  }

  /** Noise that looks like the start of a message of another dialect. */
  @Test
  void accept_falseStartOfAnUnknownMessage_losesNoMessageBehindIt() {
    for (int length = 0; length < 256; length++) {
      stream.reset();
      heard.clear();
      say((byte) 0xFD, (byte) length, (byte) 0, (byte) 7, (byte) 1, (byte) 1);
      say((byte) 0x50, (byte) 0xC3, (byte) 0);
      for (int i = 0; i < 12; i++) {
        say(POSITION);
      }
      assertThat(heard).as("length " + length).hasSize(12);
    }
  }

  @Test
  void accept_anyBitTurned_isRefusedAndTheNextIsRead() {
    for (int bit = 8; bit < 8 * ATTITUDE.length; bit++) {
      stream.reset();
      heard.clear();
      byte[] turned = ATTITUDE.clone();
      turned[bit / 8] ^= (byte) (1 << bit % 8);
      say(turned);
      for (int i = 0; i < 12; i++) { // a wrong length waits for up to 280 bytes
        say(POSITION);
      }
      assertThat(heard).as("bit " + bit).isNotEmpty();
      assertThat(heard)
          .as("bit " + bit)
          .allSatisfy(each -> assertThat(each.payload()).isInstanceOf(GlobalPositionInt.class));
    }
    assertThat(stream.malformed()).isPositive();
  }

  @Property(tries = 200)
  void accept_anyPieces_areTheSameMessages(
      @ForAll @IntRange(min = 1, max = 60) int piece, @ForAll byte[] noise) {
    MavlinkStream any = new MavlinkStream(255, 191);
    List<Object> messages = new ArrayList<>();
    byte[] clean = noise.clone();
    for (int i = 0; i < clean.length; i++) { // noise that begins no frame
      clean[i] = (clean[i] & 0xFE) == 0xFC || (clean[i] & 0xFE) == 0xFE ? 0 : clean[i];
    }
    byte[] whole = new byte[clean.length + ATTITUDE.length + POSITION.length];
    System.arraycopy(clean, 0, whole, 0, clean.length);
    System.arraycopy(ATTITUDE, 0, whole, clean.length, ATTITUDE.length);
    System.arraycopy(POSITION, 0, whole, clean.length + ATTITUDE.length, POSITION.length);
    for (int from = 0; from < whole.length; from += piece) {
      byte[] part = Arrays.copyOfRange(whole, from, Math.min(whole.length, from + piece));
      any.accept(part, part.length, each -> messages.add(each.payload()));
    }
    assertThat(messages).hasSize(2);
  }

  @Property(tries = 200)
  void accept_anyBytes_noExceptionAndItIsReadAgain(@ForAll byte[] noise) {
    MavlinkStream any = new MavlinkStream(255, 191);
    List<Object> messages = new ArrayList<>();
    any.accept(noise, noise.length, each -> messages.add(each.payload()));
    for (int i = 0; i < 12; i++) {
      any.accept(POSITION, POSITION.length, each -> messages.add(each.payload()));
    }
    assertThat(messages).hasAtLeastOneElementOfType(GlobalPositionInt.class);
  }

  @Test
  void accept_anyMessageOfRandomContentUnderARightChecksum_neverThrows() {
    Random random = new Random(20L);
    MavlinkStream any = new MavlinkStream(255, 191);
    List<Object> messages = new ArrayList<>();
    ArdupilotmegaDialect dialect = new ArdupilotmegaDialect();
    for (int id = 0; id < 20_000; id++) {
      if (!dialect.supports(id)) {
        continue;
      }
      Class<?> type = dialect.resolve(id);
      MavlinkMessageInfo info = type.getAnnotation(MavlinkMessageInfo.class);
      for (int i = 0; i < 10; i++) {
        byte[] payload = new byte[random.nextInt(256)];
        random.nextBytes(payload);
        byte[] frame =
            MavlinkPacket.createUnsignedMavlink2Packet(i, 7, 1, info.id(), info.crc(), payload)
                .getRawBytes();
        any.accept(frame, frame.length, each -> messages.add(each.payload()));
      }
    }
    assertThat(messages).hasSizeGreaterThan(1_000);
  }

  @Test
  void accept_messageThatItsReceiverRefuses_isMalformedWithTheReason() {
    stream.accept(
        POSITION,
        POSITION.length,
        each -> {
          throw new IllegalArgumentException("latitude 91.0 is outside ±90 deg");
        });
    assertThat(stream.malformed()).isEqualTo(1);
    assertThat(stream.lastRefusal())
        .isEqualTo("GlobalPositionInt: latitude 91.0 is outside ±90 deg");
  }
}
