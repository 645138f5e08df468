package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.flightgear.link.Simulator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.scenarios.estimate.EstimateErrors;
import org.u2sa.scenarios.estimate.EstimateErrors.Quantity;
import org.u2sa.scenarios.estimate.EstimateErrors.Truth;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.testkit.Repository;

/** The Cessna's state on noisy sensors errs by as much as it says, measured against truth. */
@Tag("long")
class HonestFlightTest {
  private static final double FLIGHT_S = 400.0;
  private static final double SETTLED_S = 30.0;
  private static final int SEEDS = 3;

  @TempDir private Path directory;

  /** Compares each state with the truth, carried on to the state's time by its velocity. */
  private static final class Comparison extends PeriodicService {
    private final EstimateErrors errors;
    private StateInformation truth;

    Comparison(ServiceContext context, EstimateErrors errors) {
      super(context, ServiceRole.OBSERVER, "Comparison", 1.0);
      this.errors = errors;
      registerSubscriber(Channels.STATE);
      registerSubscriber(Simulator.TRUTH);
    }

    @Override
    protected void step(double nowS) {}

    @Override
    public void callback(U2SAData data) {
      if (!(data instanceof StateInformation state)) {
        return;
      }
      if (data instanceof AircraftState && !"StateEstimator".equals(state.sensorName())) {
        truth = state;
      } else if (truth != null && Clock.seconds(state.timestamp().orElseThrow()) > SETTLED_S) {
        errors.add(state, at(state.timestamp().orElseThrow()));
      }
    }

    private Truth at(long micros) {
      double dt = Clock.seconds(micros - truth.timestamp().orElseThrow());
      double vx = truth.xDot().orElseThrow();
      double vy = truth.yDot().orElseThrow();
      double metresPerDeg = 111_320.0;
      double x = truth.x().orElseThrow();
      double y = truth.y().orElseThrow();
      double cos = Math.cos(Math.toRadians(y));
      Geodetic place =
          new Geodetic(
              x + dt * vx / (metresPerDeg * cos),
              y + dt * vy / metresPerDeg,
              truth.z().orElseThrow());
      double psi = truth.psi().orElseThrow() + dt * truth.psiDot().orElse(0.0);
      return new Truth(place, psi, Math.hypot(vx, vy));
    }
  }

  private void fly(long seed, EstimateErrors errors) throws Exception {
    Path home = Repository.root();
    Path mission = home.resolve("missions/cessna/mission.xml").toAbsolutePath();
    LockstepClock clock = new LockstepClock();
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(seed)
            .logDirectory(directory)
            .override("CommunicationManager", "BROKER", "none")
            .override("MissionManager", "MISSION", mission.toString())
            .override("Simulator", "MISSION", mission.toString())
            .override("Simulator", "LINK", "embedded");
    options.devices(TroubledFlight.devices(mission, DemoWind.ofSeed(seed), seed));
    SystemFile system = SystemFile.read(home.resolve("config/cessna/system-fused.xml"));
    try (RunningSystem running = RunningSystem.start(system, options)) {
      Comparison comparison =
          new Comparison(
              running.contextFor(XmlConfiguration.inMemory("Comparison", Map.of())), errors);
      comparison.start();
      clock.advance(Clock.micros(FLIGHT_S));
      comparison.kill();
    }
  }

  @Test
  void fly_threeSeeds_errsByWhatItClaims() throws Exception {
    EstimateErrors errors = new EstimateErrors();
    for (long seed = 1; seed <= SEEDS; seed++) {
      fly(seed, errors);
    }
    errors.report("Cessna, seeds 1…3");
    for (Quantity each : Quantity.values()) {
      assertThat(errors.within(each, 3)).as(each + " within 3 sigma").isGreaterThan(0.95);
      assertThat(errors.normalisedSquare(each)).as(each + " NEES").isBetween(0.02, 2.0);
    }
  }
}
