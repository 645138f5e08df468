package org.u2sa.drivers.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.nmea.Nmea;

class NmeaRadarTest {
  private static final String TRACKED = "RATTM,%s,%s,%s,T,7.0,20.0,T,0.0,0.0,%s,,%s,,154125.82,A";

  private final MemoryLink link = new MemoryLink();
  private final NmeaRadar radar = new NmeaRadar(link);

  private TrackingRadar.Tracks heard(long micros, String sentence) {
    link.fromDevice(Nmea.bytes(sentence));
    return radar.read(micros).orElseThrow();
  }

  private static String ttm(String id, String distance, String bearing, String unit, String state) {
    return String.format(TRACKED, id, distance, bearing, unit, state);
  }

  private static String ids(TrackingRadar.Tracks tracks) {
    return tracks.tracks().stream().map(TrackingRadar.Track::id).collect(Collectors.joining(" "));
  }

  @Test
  void read_nauticalMiles_areMetresAndKnots() {
    TrackingRadar.Track track = heard(5, ttm("11", "11.4", "13.6", "N", "T")).tracks().get(0);

    assertThat(track.id()).isEqualTo("11");
    assertThat(track.rangeM()).isCloseTo(11.4 * 1852.0, within(1e-6));
    assertThat(Math.toDegrees(track.bearing().rad())).isCloseTo(13.6, within(1e-9));
    assertThat(track.bearing().isTrue()).isTrue();
    assertThat(track.speedMps().orElseThrow()).isCloseTo(3.601, within(0.001));
    assertThat(track.measuredAtMicros()).isEqualTo(5);
  }

  @Test
  void read_targetLostOrAcquired_isNoTrack() {
    heard(1, ttm("1", "1.0", "0.0", "K", "T"));
    assertThat(ids(heard(2, ttm("2", "1.0", "0.0", "K", "Q")))).isEqualTo("1");
    assertThat(ids(heard(3, ttm("3", "1.0", "0.0", "K", "T")))).isEqualTo("1 3");
    assertThat(ids(heard(4, ttm("1", "", "", "", "L")))).isEqualTo("3");
  }

  @Test
  void read_targetSilentForAMinute_isDropped() {
    heard(0, ttm("1", "1.0", "0.0", "K", "T"));

    assertThat(ids(heard(60_000_001, ttm("2", "1.0", "0.0", "K", "T")))).isEqualTo("2");
  }

  /** A broken radar may have ten thousand, and each sentence would cost time for all of them. */
  @Test
  void read_moreTargetsThanAnyRadarTracks_keepsToTheFirstThousand() {
    TrackingRadar.Tracks tracks = null;
    for (int id = 0; id < 1_001; id++) {
      tracks = heard(id, ttm(String.valueOf(id), "1.0", "0.0", "K", "T"));
    }
    assertThat(tracks.tracks()).hasSize(1_000).noneMatch(track -> track.id().equals("1000"));
    assertThat(heard(2_000, ttm("7", "1.0", "0.0", "K", "T")).tracks())
        .anyMatch(track -> track.measuredAtMicros() == 2_000);
    heard(3_000, ttm("3", "", "", "", "L"));
    assertThat(ids(heard(4_000, ttm("1000", "1.0", "0.0", "K", "T")))).contains("1000");
  }

  @Test
  void read_noCourse_hasNoVelocity() {
    TrackingRadar.Track track = heard(1, "RATTM,1,1.0,10.0,R,,,T,0.0,0.0,N,,T,,,A").tracks().get(0);

    assertThat(track.speedMps()).isEmpty();
    assertThat(track.course()).isEmpty();
    assertThat(track.bearing().isTrue()).isFalse();
  }

  @ParameterizedTest
  @CsvSource({
    "99999, 1.0, 0.0, N, target 99999 is outside 0.0…9999.0",
    "1, -1.0, 0.0, N, distance -1.0 is outside 0.0…",
    "1, 1.0, 400, N, bearing 400 is outside 0.0…360.0",
    "1, 1.0, 0.0, X, unit \"X\": expected",
    "1, NaN, 0.0, N, distance NaN is outside",
  })
  void read_absurdValue_isRefusedByName(
      String id, String distance, String bearing, String unit, String reason) {
    heard(1, ttm("5", "1.0", "0.0", "N", "T"));

    assertThat(ids(heard(2, ttm(id, distance, bearing, unit, "T")))).isEqualTo("5");
    assertThat(radar.malformed()).isOne();
    assertThat(radar.lastRefusal()).startsWith(reason);
  }
}
