package org.u2sa.recorder;

import java.nio.file.Path;
import java.util.Map;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/** Records, and exits with 7 while most of it waits to be written. Argument: the folder. */
final class ExitingProgram {
  static final int MESSAGES = 8_000;

  private ExitingProgram() {}

  public static void main(String[] args) {
    LocalBus bus = new LocalBus("rover");
    new Recorder(
        ServiceContext.of("rover", XmlConfiguration.inMemory("Recorder", Map.of("FORM", "U2SA")))
            .transport(bus)
            .logDirectory(Path.of(args[0]))
            .build());
    Connection publisher = bus.connect("Publisher", new RecorderTest.Silent());
    for (int i = 0; i < MESSAGES; i++) {
      StateInformation message = new StateInformation().sensorName("gps").x(i * 1e-3).y(48.0);
      message.systemId("rover");
      message.timestamp(i);
      message.freeze();
      publisher.publish(Channels.STATE, message);
    }
    System.exit(7);
  }
}
