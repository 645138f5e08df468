package org.u2sa.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.Ping;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** Message signing: who is heard, and that nobody is heard twice. */
@SuppressWarnings("deprecation") // Ping: any message would do
class MavlinkSigningTest {
  private static final long NOW_MICROS = 1_800_000_000_000_000L;

  private final AtomicLong clock = new AtomicLong(NOW_MICROS);
  private final MavlinkStream vehicle = stream(1, "secret", clock);

  private static MavlinkStream stream(int system, String passphrase, AtomicLong clock) {
    return new MavlinkStream(system, 1, Optional.of(new MavlinkSigning(passphrase, clock::get)));
  }

  private static byte[] ping(MavlinkStream from) {
    return from.encode(
        Ping.builder().timeUsec(BigInteger.ONE).seq(7).targetSystem(0).targetComponent(0).build());
  }

  private List<Object> heard(byte[] packet) {
    List<Object> heard = new ArrayList<>();
    vehicle.accept(packet, packet.length, received -> heard.add(received.payload()));
    return heard;
  }

  @Test
  void accept_signedWithTheKey_isHeard() {
    MavlinkStream station = stream(255, "secret", clock);
    assertThat(heard(ping(station))).hasSize(1);
    assertThat(heard(ping(station))).hasSize(1);
  }

  @Test
  void accept_samePacketAgain_isRefused() {
    byte[] packet = ping(stream(255, "secret", clock));
    assertThat(heard(packet)).hasSize(1);
    assertThat(heard(packet)).isEmpty();
    assertThat(vehicle.lastRefusal()).isEqualTo("Ping: outdated signature");
  }

  @Test
  void isAdmissible_asAccept_withoutUsingUpTheTimestamp() {
    byte[] packet = ping(stream(255, "secret", clock));
    assertThat(vehicle.isAdmissible(packet)).isTrue();
    assertThat(vehicle.isAdmissible(ping(stream(255, "guess", clock)))).isFalse();
    assertThat(vehicle.isAdmissible(ping(new MavlinkStream(255, 1)))).isFalse();
    assertThat(heard(packet)).hasSize(1);
    assertThat(vehicle.isAdmissible(packet)).isFalse();
    assertThat(new MavlinkStream(1, 1).isAdmissible(packet)).isTrue();
  }

  @Test
  void accept_otherKeyOrUnsigned_isRefused() {
    assertThat(heard(ping(stream(255, "guess", clock)))).isEmpty();
    assertThat(vehicle.lastRefusal()).isEqualTo("Ping: wrong signature");
    assertThat(heard(ping(new MavlinkStream(255, 1)))).isEmpty();
    assertThat(vehicle.lastRefusal()).isEqualTo("Ping: not signed");
  }

  @Test
  void accept_newStreamOlderThanAMinute_isRefused() {
    byte[] recorded = ping(stream(255, "secret", clock));
    clock.addAndGet(61_000_000);
    assertThat(heard(recorded)).isEmpty();
    assertThat(heard(ping(stream(254, "secret", clock)))).hasSize(1);
  }

  @Test
  void accept_newStreamOlderThanTheStart_isRefusedUntilTheStationIsInTime() {
    AtomicLong behind = new AtomicLong(NOW_MICROS - 1_000_000);
    MavlinkStream station = stream(255, "secret", behind);
    assertThat(heard(ping(station))).isEmpty();
    assertThat(vehicle.lastRefusal()).isEqualTo("Ping: outdated signature of a new stream");
    clock.addAndGet(2_000_000);
    behind.addAndGet(2_000_000);
    assertThat(heard(ping(station))).hasSize(1);
  }

  /** As stations do: mavlink.io/en/guide/message_signing, "Timestamp Handling". */
  @Test
  void accept_stationBehindThatFollowsTheVehiclesTimestamps_isHeard() {
    MavlinkStream station = stream(255, "secret", new AtomicLong(NOW_MICROS - 30_000_000));
    byte[] heartbeat = ping(vehicle);
    station.accept(heartbeat, heartbeat.length, received -> {});
    assertThat(heard(ping(station))).hasSize(1);
  }

  @Test
  void accept_stationsClockWasAheadAndIsSetBack_isHeardOnceItHasHeardTheVehicle() {
    List<String> warnings = new ArrayList<>();
    MavlinkSigning signing = new MavlinkSigning("secret", clock::get, warnings::add);
    MavlinkStream before = new MavlinkStream(1, 1, Optional.of(signing.link()));
    byte[] ahead = ping(stream(255, "secret", new AtomicLong(NOW_MICROS + 3_600_000_000L)));
    before.accept(ahead, ahead.length, received -> {});

    MavlinkStream again =
        new MavlinkStream(1, 1, Optional.of(signing.link())); // after reconnecting
    MavlinkStream station = stream(255, "secret", clock);
    List<Object> heard = new ArrayList<>();
    byte[] first = ping(station);
    again.accept(first, first.length, heard::add);
    assertThat(heard).isEmpty();
    assertThat(warnings).singleElement().asString().contains("3600.0 s before its newest one");

    byte[] heartbeat = ping(again);
    station.accept(heartbeat, heartbeat.length, received -> {});
    byte[] second = ping(station);
    again.accept(second, second.length, heard::add);
    assertThat(heard).hasSize(1);
  }

  @Test
  void accept_clockOfAStationDecadesAhead_othersAreStillHeard() {
    AtomicLong ahead = new AtomicLong(NOW_MICROS + 40L * 365 * 86_400 * 1_000_000);
    assertThat(heard(ping(stream(250, "secret", ahead)))).hasSize(1);
    assertThat(heard(ping(stream(254, "secret", clock)))).hasSize(1);
  }

  @Test
  void accept_clockNeverSet_followsTheStations() {
    byte[] recorded = ping(stream(255, "secret", clock));
    clock.addAndGet(61_000_000);
    MavlinkStream unset = stream(1, "secret", new AtomicLong(86_400_000_000L));
    byte[] packet = ping(stream(254, "secret", clock));
    List<Object> heard = new ArrayList<>();
    unset.accept(packet, packet.length, heard::add);
    unset.accept(recorded, recorded.length, heard::add);
    assertThat(heard).hasSize(1);
    assertThat(timestamp(ping(unset))).isGreaterThan(timestamp(packet));
  }

  @Test
  void sign_stationWithTheLatestTimestamp_ourTimestampsGoOn() {
    AtomicLong last = new AtomicLong((1L << 48) * 10 - 50 + 1_420_070_400_000_000L);
    assertThat(heard(ping(stream(250, "secret", last)))).hasSize(1);
    long before = timestamp(ping(vehicle));
    assertThat(timestamp(ping(vehicle))).isGreaterThan(before).isGreaterThan(1L << 47);
  }

  @Test
  void link_packetOfAnotherLink_isRefusedButItsTimeIsNotFollowed() {
    MavlinkSigning first = new MavlinkSigning("secret", clock::get);
    MavlinkStream one = new MavlinkStream(1, 1, Optional.of(first));
    MavlinkStream other = new MavlinkStream(1, 1, Optional.of(first.link()));
    byte[] packet = ping(stream(250, "secret", new AtomicLong(NOW_MICROS + 3_600_000_000L)));
    List<Object> heard = new ArrayList<>();
    one.accept(packet, packet.length, heard::add);
    other.accept(packet, packet.length, heard::add);
    assertThat(heard).hasSize(1);
    assertThat(timestamp(ping(one))).isGreaterThan(timestamp(packet));
    assertThat(timestamp(ping(other))).isLessThan(timestamp(packet));
  }

  private static long timestamp(byte[] packet) {
    long time = 0;
    for (int i = packet.length - 7; i >= packet.length - 12; i--) {
      time = time << 8 | packet[i] & 0xFF;
    }
    return time;
  }

  @Test
  void accept_changedAnywhere_isRefused() {
    byte[] packet = ping(stream(255, "secret", clock));
    for (int i = 0; i < packet.length; i++) {
      byte[] changed = packet.clone();
      changed[i] ^= 0x10;
      vehicle.reset();
      assertThat(heard(changed)).as("byte " + i).isEmpty();
    }
  }
}
