package org.u2sa.scenarios.barn;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.testkit.Repository;

/** Worlds in BARN's format, made here: read, scored, and one driven with the default settings. */
class BarnTest {
  private static final double SCALE = 0.52 / BarnCourse.JACKAL_WIDTH_M;

  @TempDir private Path folder;

  private void writePath(long... cells) throws IOException {
    byte[] header = "{'descr': '<i8'}\n".getBytes(StandardCharsets.US_ASCII);
    ByteBuffer npy = ByteBuffer.allocate(10 + header.length + Long.BYTES * cells.length);
    npy.order(ByteOrder.LITTLE_ENDIAN).put(new byte[] {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0});
    npy.putShort((short) header.length).put(header);
    for (long cell : cells) {
      npy.putLong(cell);
    }
    Files.createDirectories(folder.resolve("path_files"));
    Files.write(folder.resolve("path_files/path_7.npy"), npy.array());
  }

  private BarnWorld world(StringBuilder pillars) throws IOException {
    Files.writeString(folder.resolve("world_7.world"), "<sdf>" + pillars + "</sdf>");
    writePath(17, 0, 17, 29);
    return BarnWorld.read(folder, 7);
  }

  private static void pillar(StringBuilder text, double x, double y) {
    text.append(
        String.format(
            Locale.ROOT,
            "<model name='unit_cylinder_%d'>%n <static>1</static>%n"
                + " <pose frame=''>%.6f %.6f 0 0 0 0</pose></model>%n",
            text.length(),
            x,
            y));
  }

  @Test
  void read_worldAndPath_hasPillarsAndTheLengthThatTheChallengeCounts() throws IOException {
    StringBuilder text = new StringBuilder();
    pillar(text, -1.5, 6.0);
    BarnWorld world = world(text);
    assertThat(world.pillars()).containsExactly(new BarnWorld.Place(-1.5, 6.0));
    // from (-2, 3) to (-2.025, 5.075), to (-2.025, 9.425), to (-2, 13)
    assertThat(world.pathM()).isCloseTo(2.07515 + 4.35 + 3.57509, within(1.0e-4));
  }

  @Test
  void read_noPillars_namesTheFile() throws IOException {
    assertThatThrownBy(() -> world(new StringBuilder()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("world_7.world: no unit_cylinder");
  }

  @Test
  void metric_timeOrContact_isAsTheChallengeHasIt() {
    assertThat(new BarnScore(0, 10.0, BarnScore.Outcome.REACHED, 12.0).metric(1.0)).isEqualTo(0.25);
    assertThat(new BarnScore(0, 10.0, BarnScore.Outcome.REACHED, 50.0).metric(1.0)).isEqualTo(0.2);
    assertThat(new BarnScore(0, 10.0, BarnScore.Outcome.REACHED, 99.0).metric(1.0))
        .isEqualTo(0.125);
    assertThat(new BarnScore(0, 10.0, BarnScore.Outcome.TOUCHED, 12.0).metric(1.0)).isZero();
  }

  @Test
  void score_track_countsFromTheFirstMovementToTheGoal() {
    BarnCourse course = new BarnCourse(new BarnWorld(7, List.of(), 10.0), 1.0);
    List<String> track =
        List.of(
            "time_s,longitude_deg,latitude_deg",
            "1.0,-81.0478,29.1885",
            "3.0,-81.0478,29.18850200",
            "20.0,-81.0478,29.18858200",
            "25.0,-81.0478,29.18859000");
    BarnScore score = BarnDrive.score(course, track, 0);
    assertThat(score.outcome()).isEqualTo(BarnScore.Outcome.REACHED);
    assertThat(score.timeS()).isEqualTo(17.0);
    assertThat(BarnDrive.score(course, track, 1).outcome()).isEqualTo(BarnScore.Outcome.TOUCHED);
    assertThat(BarnDrive.score(course, track.subList(0, 3), 0).outcome())
        .isEqualTo(BarnScore.Outcome.NOT_REACHED);
  }

  /** Two walls across with gaps of 0.75 m, 0.91 m when scaled: the vehicle cannot turn in them. */
  @Test
  void drive_gapsTooNarrowToTurnIn_reachesTheGoalWithDefaultSettings() throws IOException {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 64; i++) {
      pillar(text, -4.425, 0.075 + 0.15 * i);
      pillar(text, -0.075, 0.075 + 0.15 * i);
    }
    for (int i = 1; i < 30; i++) {
      pillar(text, -4.425 + 0.15 * i, 0.075);
      if (i < 16 || i > 21) {
        pillar(text, -4.425 + 0.15 * i, 6.075);
      }
      if (i < 8 || i > 13) {
        pillar(text, -4.425 + 0.15 * i, 8.325);
      }
    }
    BarnCourse course = new BarnCourse(world(text), SCALE);
    System.setProperty("u2sa.home", Repository.root().toString());

    BarnScore score = BarnDrive.drive(course, folder.resolve("run"), List.of());

    assertThat(score.outcome()).isEqualTo(BarnScore.Outcome.REACHED);
    assertThat(score.metric(1.0)).isEqualTo(BarnScore.BEST);
  }
}
