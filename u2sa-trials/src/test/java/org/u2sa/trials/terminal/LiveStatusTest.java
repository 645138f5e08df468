package org.u2sa.trials.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.report.score.TrackSample;

class LiveStatusTest {

  private static final String ESCAPE = "\u001b";

  private final StringWriter text = new StringWriter();
  private final PrintWriter out = new PrintWriter(text);

  private static LiveStatus.Moment status(
      String phase, int waypoint, double simulatedS, double elapsedS) {
    TrackSample.Flight flight = new TrackSample.Flight(Math.toRadians(-12.0), 0.0, 51.4, false);
    TrackSample sample =
        new TrackSample(
            simulatedS,
            -157.9,
            21.3,
            914.4,
            0.0,
            50.0,
            OptionalDouble.of(14.2),
            waypoint - 1,
            phase,
            Optional.of(flight));
    return new LiveStatus.Moment(sample, waypoint, 10, "Ridge", () -> 2310.0, elapsedS);
  }

  private Terminal interactive(int columns) {
    return new Terminal(out, true, true, columns);
  }

  @Test
  void update_pipe_printsAtChangesAndEveryTenSimulatedSeconds() {
    LiveStatus live = new LiveStatus(new Terminal(out, false, false, 80));
    live.update(status("ROLL", 1, 0.0, 0.0));
    live.update(status("ROLL", 1, 9.9, 0.1));
    live.update(status("ROLL", 1, 10.0, 0.2));
    live.update(status("CLIMB", 1, 11.0, 0.3));
    live.update(status("CLIMB", 2, 12.0, 0.4));
    live.update(status("CLIMB", 2, 13.0, 0.5));
    assertThat(text.toString().lines()).hasSize(4);
    assertThat(text.toString()).doesNotContain(ESCAPE, "\r");
    assertThat(text.toString().lines().skip(2).findFirst())
        .contains(
            "00:11  CLIMB      waypoint 1 of 10 (Ridge), 2.31 km to go  altitude 914 m  speed 51.4 m/s  bank -12 deg  off track +14 m  elapsed 00:00");
  }

  @Test
  void close_pipe_printsTheLastMomentOnce() {
    LiveStatus live = new LiveStatus(new Terminal(out, false, false, 80));
    live.update(status("ROLL", 1, 0.0, 0.0));
    live.update(status("ROLL", 1, 5.0, 0.1));
    live.close();
    live.close();
    assertThat(text.toString().lines()).hasSize(2);
  }

  @Test
  void update_terminal_redrawsThreeLinesInPlaceAtMostTenTimesASecond() {
    LiveStatus live = new LiveStatus(interactive(100));
    for (int i = 0; i < 1000; i++) {
      live.update(status("LEG", 4, i, i * 0.001)); // one second of the wall
    }
    assertThat(text.toString().split("\n", -1)).hasSize(1 + 3 * 10);
    assertThat(text.toString().split(ESCAPE + "\\[3A", -1)).hasSize(10);
    assertThat(text.toString())
        .contains(
            "LEG",
            "[######..............]",
            "waypoint 4 of 10 (Ridge)",
            "914 m",
            "51.4 m/s",
            "-12 deg",
            "+14 m");
  }

  @Test
  void update_narrowTerminal_neverWraps() {
    LiveStatus live = new LiveStatus(new Terminal(out, true, false, 30));
    live.update(status("LEG", 4, 100.0, 2.0));
    String plain = text.toString().replaceAll(ESCAPE + "\\[[0-9]*[A-Za-z]", "").replace("\r", "");
    assertThat(plain.lines()).allSatisfy(line -> assertThat(line.length()).isLessThan(30));
  }

  @Test
  void update_noColour_hasNoStyles() {
    LiveStatus live = new LiveStatus(new Terminal(out, true, false, 100));
    live.update(status("LEG", 4, 100.0, 2.0));
    assertThat(text.toString()).doesNotContainPattern(ESCAPE + "\\[[0-9]*m");
  }

  @Test
  void print_terminal_isAboveThePanel() {
    LiveStatus live = new LiveStatus(interactive(100));
    live.update(status("LEG", 4, 100.0, 2.0));
    live.print("disarmed");
    live.close();

    String[] parts = text.toString().split("disarmed", -1);
    assertThat(parts).hasSize(2);
    assertThat(parts[0]).endsWith(ESCAPE + "[3A\r" + ESCAPE + "[J"); // removes the panel
    assertThat(parts[1]).contains("waypoint 4 of 10").doesNotContain(ESCAPE + "[3A");
  }

  private static LiveStatus.Moment onTheGround(int leg) {
    TrackSample sample =
        new TrackSample(
            1.0, 8.0, 50.0, 0.0, 0.0, 0.5, OptionalDouble.empty(), leg, "DRIVES", Optional.empty());
    return new LiveStatus.Moment(sample, leg + 1, 6, "", () -> 0.0, 1.0);
  }

  @ParameterizedTest
  @CsvSource({"-1, no waypoint", "6, no waypoint left"})
  void update_noTarget_showsNeitherDistanceNorDeviation(int leg, String target) {
    LiveStatus live = new LiveStatus(new Terminal(out, false, false, 80));
    live.update(onTheGround(leg));

    assertThat(text.toString())
        .isEqualToIgnoringNewLines(
            "00:01  DRIVES     " + target + "  speed 0.50 m/s  heading 0 deg  elapsed 00:01");
  }
}
