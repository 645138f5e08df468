package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.Servo;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.testkit.DeviceContract;

/** Every servo, in the middle of its travel. */
class ServoPortTest extends DeviceContract<Servo.Position> {
  static final Maestro.Variables WIRING = new Maestro.Variables(3, 1500.0, 600.0, 1000.0, 2000.0);

  @Override
  protected List<Bench<Servo.Position>> benches() {
    MemoryLink link = new MemoryLink();
    LinkedBench<Servo.Position> maestro =
        new LinkedBench<>("MAESTRO", link, new Maestro(link, WIRING), Long.MAX_VALUE, line -> {});
    new SimulatedMaestro(link);
    return List.of(maestro);
  }

  @Override
  protected void judge(Servo.Position position) {
    assertThat(position.angleRad().orElseThrow()).isCloseTo(0.0, within(1e-3));
  }
}
