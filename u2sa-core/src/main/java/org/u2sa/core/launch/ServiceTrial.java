package org.u2sa.core.launch;

import java.io.IOException;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.TrialEndedException;

/**
 * Constructs a service once before the running one is ended for it: whatever its constructor
 * refuses, such as a file that a variable names, must leave the running one alone. It is connected
 * to nobody, is never started, and ends where it would open a device.
 */
final class ServiceTrial {
  private final String systemId;
  private final LaunchOptions options;
  private final MessageTypes types;

  ServiceTrial(String systemId, LaunchOptions options, MessageTypes types) {
    this.systemId = systemId;
    this.options = options;
    this.types = types;
  }

  /**
   * Constructs the service, and discards it. Does nothing for a class with a maker of its own,
   * which may hold devices of the host.
   *
   * @param configuration read for this trial
   * @throws RuntimeException what its constructor threw
   */
  void require(String className, XmlConfiguration configuration) {
    if (options.makerOf(className).isPresent()) {
      return;
    }
    try (TemporaryFolder logs = TemporaryFolder.create("u2sa-trial")) {
      construct(className, context(configuration, logs));
    } catch (IOException e) { // a full disk must not prevent a restart
      options.console().accept("Restart without a trial: " + e);
    }
  }

  private ServiceContext context(XmlConfiguration configuration, TemporaryFolder logs) {
    return ServiceContext.of(systemId, configuration)
        .clock(options.clock())
        .transport(new LocalBus(systemId))
        .logDirectory(logs.path())
        .messageTypes(types)
        .seed(options.seed())
        .restart(true)
        .devices(options.devices())
        .trial(true)
        .build();
  }

  private static void construct(String className, ServiceContext context) {
    try {
      ServiceFactory.create(className, context).shutDown();
      context.configuration().refuseUndeclared();
    } catch (TrialEndedException e) {
      return; // what comes before its device was accepted
    } finally {
      context.abandon();
    }
  }
}
