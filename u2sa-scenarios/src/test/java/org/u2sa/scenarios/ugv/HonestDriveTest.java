package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.scenarios.estimate.EstimateErrors;
import org.u2sa.scenarios.estimate.EstimateErrors.Quantity;
import org.u2sa.scenarios.estimate.EstimateErrors.Truth;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.vehicle.VehicleTruth;

/** The ground vehicle's state errs by as much as it says, measured against truth. */
class HonestDriveTest {
  private static final double SETTLED_S = 5.0;
  private static final double LOOP_S = 120.0;
  private static final double PART_S = 40.0; // a straight, a turn and half a straight
  private static final int SEEDS = 5;

  @TempDir private Path directory;

  private void drive(
      long seed, double seconds, Consumer<LaunchOptions> changed, EstimateErrors errors)
      throws Exception {
    UgvDrive.Scene scene = new UgvDrive.Scene(seed, GpsGrade.SURVEY, Hazards.none(), List.of());
    try (UgvDrive drive =
        new UgvDrive(
            directory.resolve("logs"),
            UgvDrive.config().resolve("system.xml"),
            scene,
            true,
            changed)) {
      drive.operator.onState(
          state -> {
            if (drive.nowS() >= SETTLED_S) {
              errors.add(state, truth(drive));
            }
          });
      drive.drive(seconds);
    }
  }

  private static Truth truth(UgvDrive drive) {
    VehicleTruth truth = drive.vehicle.truth();
    Geodetic place =
        drive.vehicle.world().plane().at(truth.position().x(), truth.position().y(), 0.0);
    return new Truth(place, truth.headingRad(), truth.speedMps());
  }

  private static void requireHonest(EstimateErrors errors) {
    for (Quantity each : Quantity.values()) {
      assertThat(errors.within(each, 3)).as(each + " within 3 sigma").isGreaterThan(0.97);
      assertThat(errors.normalisedSquare(each)).as(each + " NEES").isBetween(0.05, 1.6);
    }
  }

  /** One drive's errors persist: a straight and a turn say less than five loops. */
  @Test
  void drive_configuredDelay_errsByWhatItClaims() throws Exception {
    EstimateErrors errors = new EstimateErrors();
    drive(1, PART_S, options -> {}, errors);
    errors.report("ground vehicle, part of a loop");
    requireHonest(errors);
  }

  /** A fix is 0.1 s late: 0.1 m at the vehicle's speed, ten times what the filter claims. */
  @Tag("long")
  @Test
  void drive_delayIsNotTold_isLearntAndSaid() throws Exception {
    EstimateErrors errors = new EstimateErrors();
    drive(1, LOOP_S, options -> options.override("IoioService", "GPS DELAY", 0.0), errors);
    errors.report("ground vehicle, GPS DELAY told as 0");
    requireHonest(errors);
  }

  @Tag("long")
  @Test
  void drive_fiveSeeds_errsByWhatItClaims() throws Exception {
    EstimateErrors errors = new EstimateErrors();
    for (long seed = 1; seed <= SEEDS; seed++) {
      drive(seed, LOOP_S, options -> {}, errors);
    }
    errors.report("ground vehicle, seeds 1…5");
    requireHonest(errors);
  }
}
