package org.u2sa.cli.mission;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Says that it stands at longitude 8, latitude 50. */
public final class StandingRover extends PeriodicService {
  /** Called by the launcher. */
  public StandingRover(ServiceContext context) {
    super(context, ServiceRole.STATE_ESTIMATOR, "StandingRover", 10.0);
    registerPublisher(Channels.STATE);
  }

  @Override
  protected void step(double nowS) {
    StateInformation state = new StateInformation().sensorName("rover").x(8.0).y(50.0);
    state.timestamp(clock().micros());
    publish(Channels.STATE, state);
  }
}
