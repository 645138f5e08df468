package org.u2sa.cli.record;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.core.communication.ManagerVariables;
import org.u2sa.core.station.StationPage;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.playback.Playback;

/**
 * Serves the operator's page for a recording through its own broker. The page finds the playback as
 * a service with the variables POSITION, RATE and PAUSED, and sets them like those of any service.
 */
final class WebPlayback implements AutoCloseable, Receiver {
  /** Name by which the page recognises a recording. */
  static final String NAME = "Playback";

  static final String POSITION = "POSITION";
  static final String RATE = "RATE";
  static final String PAUSED = "PAUSED";

  private static final double NANOS = 1e9;
  private static final double MIN_RATE = 0.1;
  private static final double MAX_RATE = 100.0;
  private static final long TELL_EVERY = 5; // position messages; 20 per second

  private final CommunicationManager manager;
  private final Connection connection;
  private final Playback playback;
  private final McapStatistics statistics;
  private final Consumer<String> log;
  private Playback.Position told; // playing thread only, like the next
  private long positions;

  /**
   * @param port of the page; the broker uses the next one
   * @param systemId the recorded system
   * @param log receives one line for each failure, and the page's address
   */
  WebPlayback(
      int port,
      String systemId,
      Playback playback,
      McapStatistics statistics,
      Consumer<String> log) {
    this.playback = playback;
    this.statistics = statistics;
    this.log = log;
    playback.holdAtEnd();
    manager =
        CommunicationManager.start(
            systemId,
            XmlConfiguration.inMemory(
                "--web", Map.of(ManagerVariables.PORT, port + 1, ManagerVariables.WEB_PORT, port)),
            MessageTypes.discovered(),
            StationPage::ofRecording,
            log);
    connection = manager.transport().connect(NAME, this);
    connection.subscribe(Channels.CONFIGURATION);
  }

  /** The connection to the page's broker. */
  Connection connection() {
    return connection;
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof ConfigurationTransaction order && order.serviceName().equals(NAME)) {
      String refusal = "";
      try {
        order.assignments().forEach(this::set);
      } catch (IllegalArgumentException e) {
        refusal = e.getMessage();
      }
      ConfigurationTransactionResult result =
          new ConfigurationTransactionResult()
              .serviceName(NAME)
              .requestId(order.requestId())
              .author(order.author())
              .assignments(order.assignments())
              .accepted(refusal.isEmpty())
              .reason(refusal);
      result.freeze();
      connection.publish(Channels.CONFIGURATION, result);
    }
  }

  private void set(ConfigurationAssignment assignment) {
    switch (assignment.variableName()) {
      case POSITION ->
          playback.seekTo(
              statistics.startNanos() + Math.round(number(assignment, 0.0, lengthS()) * NANOS));
      case RATE -> playback.rate(number(assignment, MIN_RATE, MAX_RATE));
      case PAUSED -> playback.pause(assignment.value().equals("true"));
      default -> throw new IllegalArgumentException(assignment.variableName() + ": no variable");
    }
  }

  private static double number(ConfigurationAssignment assignment, double min, double max) {
    double value;
    try {
      value = Double.parseDouble(assignment.value());
    } catch (NumberFormatException e) {
      value = Double.NaN;
    }
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s: \"%s\" is not a number in %.1f…%.1f",
              assignment.variableName(),
              assignment.value(),
              min,
              max));
    }
    return value;
  }

  private double lengthS() {
    return (statistics.endNanos() - statistics.startNanos()) / NANOS;
  }

  /** Sends the position to the page four times a second and when anything else changes. */
  void show(Playback.Position position) {
    boolean isOther =
        told == null || told.isPaused() != position.isPaused() || told.rate() != position.rate();
    if (!isOther && positions++ % TELL_EVERY != 0) {
      return;
    }
    told = position;
    ConfigurationResponse response =
        new ConfigurationResponse()
            .serviceName(NAME)
            .variables(
                List.of(
                    variable(
                            POSITION,
                            Math.max(0.0, (position.nanos() - statistics.startNanos()) / NANOS))
                        .unit("s")
                        .max(lengthS()),
                    variable(RATE, position.rate()).max(MAX_RATE),
                    new ConfigurationVariable()
                        .name(PAUSED)
                        .variableType("boolean")
                        .value(String.valueOf(position.isPaused()))));
    response.freeze();
    connection.publish(Channels.CONFIGURATION, response);
  }

  private static ConfigurationVariable variable(String name, double value) {
    return new ConfigurationVariable()
        .name(name)
        .variableType("double")
        .value(String.valueOf(value))
        .min(name.equals(RATE) ? MIN_RATE : 0.0);
  }

  @Override
  public void trouble(String what) {
    log.accept(what);
  }

  @Override
  public void close() {
    connection.close();
    manager.close();
  }
}
