package org.u2sa.cli.services;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Says that it publishes states and listens to goals; does nothing. */
public final class Lidar extends EventDrivenService {
  public Lidar(ServiceContext context) {
    super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "Lidar");
    registerPublisher(Channels.SENSED_STATE);
    registerPublisher(Channels.POWER);
    registerSubscriber(Channels.GOALS);
  }

  @Override
  public void callback(U2SAData data) {
    unexpected(data);
  }
}
