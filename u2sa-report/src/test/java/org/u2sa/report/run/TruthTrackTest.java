package org.u2sa.report.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TruthTrackTest {
  @TempDir private Path folder;

  private TruthTrack track(String first, String second) throws IOException {
    return TruthTrack.read(
        Files.writeString(
            folder.resolve("track.csv"),
            "time_s,longitude_deg,latitude_deg,altitude_m,heading_deg\n"
                + first
                + "\n"
                + second
                + "\n"));
  }

  @ParameterizedTest
  @CsvSource({
    "179.9, -179.7, 0.25, 180.0", // which is -180
    "179.9, -179.7, 0.75, -179.8",
    "-179.7, 179.9, 0.25, -179.8",
    "8.0, 8.4, 0.5, 8.2",
    "-0.2, 0.2, 0.25, -0.1"
  })
  void at_betweenTwoRows_goesTheShorterWayRound(
      double from, double to, double timeS, double expected) throws IOException {
    TruthTrack.Place place =
        track("0," + from + ",1,2,0", "1," + to + ",3,4,0").at(timeS).orElseThrow();
    assertThat(Math.IEEEremainder(place.at().longitudeDeg() - expected, 360.0))
        .isCloseTo(0.0, within(1e-9));
    assertThat(place.at().longitudeDeg()).isBetween(-180.0, 180.0);
    assertThat(place.at().latitudeDeg()).isCloseTo(1 + 2 * timeS, within(1e-9));
  }

  @Test
  void at_headingOverNorth_turnsTheShorterWay() throws IOException {
    double heading = track("0,8,50,0,350", "1,8,50,0,20").at(0.5).orElseThrow().headingRad();
    assertThat(Math.toDegrees(heading) % 360.0).isCloseTo(5.0, within(1e-9));
  }
}
