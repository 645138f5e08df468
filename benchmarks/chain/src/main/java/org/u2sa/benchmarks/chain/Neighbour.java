package org.u2sa.benchmarks.chain;

import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Publishes 50 times a second on a channel of its own, and hears that of another one. */
final class Neighbour extends PeriodicService {
  private static final double HZ = 50.0;

  private final Channel<StateInformation> own;
  private double sum; // of what was heard

  Neighbour(ServiceContext context, int number, int ofNumber) {
    super(context, ServiceRole.OBSERVER, "Neighbour" + number, HZ);
    own = channel(number);
    registerPublisher(own);
    subscribe(channel((number + 1) % ofNumber), this::hear);
  }

  private static Channel<StateInformation> channel(int number) {
    return Channel.latest("neighbour-" + number, StateInformation.TYPE, StateInformation::sensorName);
  }

  private void hear(StateInformation state) {
    sum += state.x().orElse(0.0);
  }

  @Override
  protected void step(double nowS) {
    publish(own, new StateInformation().sensorName(getServiceName()).x(nowS).y(sum % 1.0).psi(0.5));
  }
}
