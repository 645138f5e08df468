package org.u2sa.cli.configuration;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Answers configuration changes that other services were asked for: done. */
public final class HastyAnswerer extends EventDrivenService {
  /** Called by the launcher. */
  public HastyAnswerer(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "Hasty");
    subscribe(Channels.CONFIGURATION, this::answer);
  }

  private void answer(U2SAData data) {
    if (data instanceof ConfigurationTransaction change
        && !change.serviceName().equals(getServiceName())) {
      publish(
          Channels.CONFIGURATION,
          new ConfigurationTransactionResult()
              .requestId(change.requestId())
              .serviceName(getServiceName())
              .author(change.author())
              .assignments(change.assignments())
              .accepted(true)
              .revision(99));
    }
  }

  @Override
  public void callback(U2SAData data) {
    answer(data);
  }
}
