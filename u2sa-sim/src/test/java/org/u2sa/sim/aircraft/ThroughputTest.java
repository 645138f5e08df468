package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import org.junit.jupiter.api.Test;
import org.u2sa.sim.atmosphere.Wind;

class ThroughputTest {
  private static final double FLOWN_S = 600.0;

  /** Measured at 3000 to 5000; time of this thread counts, not what others take meanwhile. */
  @Test
  void step_turbulentFlightAt20Hz_runsFarFasterThanRealTime() {
    Trim trim = Trim.level(600.0, 50.0, 0.0);
    Cessna172 aircraft =
        Cessna172.inFlight(trim.start(-157.9, 21.3, 0.0, 1.0), Wind.turbulent(1.0, 5.0, 3L));
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long begun = threads.getCurrentThreadCpuTime();
    while (aircraft.state().timeS() < FLOWN_S) {
      AircraftMotion state = aircraft.state();
      aircraft.step(
          HandPilot.hold(state, trim.controls(), trim.pitchRad(), 0.0, trim.controls().elevator()),
          0.05);
    }
    double tookS = (threads.getCurrentThreadCpuTime() - begun) * 1e-9;
    System.out.printf(
        "Cessna 172: %.0f simulated seconds a second of processor%n", FLOWN_S / tookS);
    assertThat(FLOWN_S / tookS).isGreaterThan(100.0);
    assertThat(aircraft.state().crashed()).isFalse();
  }
}
