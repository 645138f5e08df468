package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.LidarSensor;
import org.u2sa.drivers.link.DeviceServer;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.RealTime;
import org.u2sa.interfaces.communication.Channels;

/** A simulated Hokuyo behind a real socket, in real time. */
class HokuyoTcpTest {
  @TempDir Path logs;

  @Test
  void step_pulledInTheMiddleOfAScanAndBack_goesOn() throws Exception {
    MemoryLink far = new MemoryLink();
    try (RealTime real = new RealTime(logs);
        DeviceServer server = new DeviceServer(far)) {
      new SimulatedHokuyo(far, real.clock()::micros, degrees -> 3.0);
      real.with("CONNECTION", server.address()).with("LIDAR", "hokuyo").with("PUBLISH EVERY", 8);
      real.start(LidarSensor::new);
      real.until(() -> real.latest(Channels.SCANS).isPresent());
      server.unplug();
      real.until(() -> real.lastError().startsWith("the laser is lost"));
      real.forget(Channels.SCANS);
      server.plug();
      real.until(() -> real.latest(Channels.SCANS).isPresent());
      assertThat(real.latest(Channels.SCANS).orElseThrow().points()).hasSize(1081);
    }
  }
}
