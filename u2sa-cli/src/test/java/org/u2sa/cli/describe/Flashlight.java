package org.u2sa.cli.describe;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Measures a place and has a lamp. */
public final class Flashlight extends PeriodicService {
  /** Called by the launcher. */
  public Flashlight(ServiceContext context) {
    super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "Flashlight", 10.0);
    registerPublisher(Channels.SENSED_STATE);
    registerPublisher(Channels.ACTUATORS);
  }

  @Override
  protected void begin() {
    publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("LAMP")
            .minimum(0.0)
            .maximum(100.0)
            .effect("lights")
            .rateLimit(50.0)
            .force(Point.of(-0.25, 0.0, 0.0)));
  }

  @Override
  protected void step(double nowS) {
    StateInformation state =
        new StateInformation().sensorName("flashlight").x(8.0).y(50.0).xSigma(1.5).ySigma(2.0);
    state.timestamp(clock().micros());
    publish(Channels.SENSED_STATE, state);
  }
}
