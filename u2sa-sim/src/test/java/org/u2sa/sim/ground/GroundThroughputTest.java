package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.ioio.PulseTrain;
import org.u2sa.sim.world.World;

class GroundThroughputTest {
  private static final int DRIVEN_S = 600;
  private static final int GPS = 6;

  /** Measured at 1000 to 2500; time of this thread counts, not what others take meanwhile. */
  @Test
  void advance_vehicleWithSensors_runsFarFasterThanRealTime() {
    MiniMolle molle = MiniMolle.in(World.at(new Geodetic(-80.42, 37.23, 600.0))).build();
    byte[] buffer = new byte[256];
    long received = 0;
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long begun = threads.getCurrentThreadCpuTime();
    for (long us = 0; us <= DRIVEN_S * 1_000_000L; us += 1_000) {
      molle.advance(us);
      if (us % 50_000 == 0) {
        double wave = 1e-4 * Math.sin(us * 1e-6);
        molle.driven(10, new PulseTrain(1.7e-3 + wave, 0.02));
        molle.driven(11, new PulseTrain(1.7e-3 - wave, 0.02));
      }
      received += molle.received(GPS, 9_600, buffer);
    }
    double tookS = (threads.getCurrentThreadCpuTime() - begun) * 1e-9;
    System.out.printf(
        "MiniMolle: %.0f simulated seconds a second of processor%n", DRIVEN_S / tookS);
    assertThat(received).isGreaterThan(8 * 100 * DRIVEN_S);
    assertThat(DRIVEN_S / tookS).isGreaterThan(100.0);
  }
}
