package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.WheelMotors;
import org.u2sa.drivers.link.DeviceServer;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.RealTime;
import org.u2sa.interfaces.communication.Channels;

/** A simulated RoboClaw behind a real socket, in real time. */
class RoboClawTcpTest {
  @TempDir Path logs;

  private static boolean drives(SimulatedRoboClaw device, RealTime real) {
    real.command("LEFT MOTOR", 50.0);
    real.command("RIGHT MOTOR", 50.0);
    return device.duty(0) > 0.45 && device.duty(1) > 0.45;
  }

  @Test
  void step_pulledWhileItDrivesAndBack_stopsAndGoesOn() throws Exception {
    MemoryLink far = new MemoryLink();
    try (RealTime real = new RealTime(logs);
        DeviceServer server = new DeviceServer(far)) {
      SimulatedRoboClaw device = new SimulatedRoboClaw(far, real.clock()::micros);
      real.with("CONNECTION", server.address()).with("COMMAND EXPIRY", 10.0);
      real.start(WheelMotors::new);
      real.until(() -> drives(device, real));
      real.until(() -> real.latest(Channels.SENSED_STATE).isPresent());
      server.unplug();
      real.until(() -> device.duty(0) == 0.0 && device.duty(1) == 0.0); // by its own time-out
      real.until(() -> real.lastError().startsWith("the motor controller is lost"));
      server.plug();
      real.until(() -> drives(device, real));
      real.kill();
      real.until(() -> device.duty(0) == 0.0); // told so when the service ended
      assertThat(device.duty(1)).isZero();
    }
  }
}
