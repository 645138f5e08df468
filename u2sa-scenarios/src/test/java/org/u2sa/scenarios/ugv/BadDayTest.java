package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.sim.ground.Hazards;

/** Drop-outs of the GPS, magnetic places, slippery patches and pushes, all in one drive. */
@Timeout(240)
class BadDayTest {
  private static final double RADIUS_M = 45.0;
  private static final double LASTS_S = 300.0;

  @TempDir private Path directory;

  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = 1)
  void drive_amongFiftyHazards_completesTheLoop(long seed) throws InterruptedException {
    Hazards hazards = Hazards.random(seed, RADIUS_M, LASTS_S);
    try (UgvDrive drive = new UgvDrive(directory, hazards, true)) {
      drive.driveUntil("round the loop", () -> drive.operator.goalsDone() == 6, LASTS_S);

      assertThat(hazards.all()).hasSizeGreaterThan(50);
      assertThat(drive.operator.action()).isEqualTo(FailsafeAction.CONTINUE);
    }
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {2, 3})
  void drive_amongOtherHazards_completesTheLoop(long seed) throws InterruptedException {
    drive_amongFiftyHazards_completesTheLoop(seed);
  }
}
