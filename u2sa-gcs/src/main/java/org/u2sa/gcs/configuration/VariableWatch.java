package org.u2sa.gcs.configuration;

import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.schema.U2SAData;

/**
 * A variable of a running service: its value, and each that it is given later by way of messages. A
 * change that a service makes to its own file is not heard.
 */
public final class VariableWatch implements AutoCloseable {
  /**
   * A value.
   *
   * @param micros when it was heard [µs of real time]
   * @param text in the declared unit
   * @param unit the declared one; empty if it has none
   * @param author who set it, by what they say themselves; empty of the first value
   */
  public record Value(long micros, String text, String unit, String author) {}

  private final BlockingQueue<Value> values = new LinkedBlockingQueue<>();
  private final Consumer<U2SAData> listener = this::take;
  private final RemoteLink link;
  private final String service;
  private final String name;
  private volatile String unit = "";

  private VariableWatch(RemoteLink link, String service, String name) {
    this.link = link;
    this.service = service;
    this.name = name;
  }

  /**
   * Asks for the value, and listens on.
   *
   * @throws org.u2sa.interfaces.BadInputException if there is no such service or variable
   */
  public static VariableWatch of(RemoteLink link, String service, String name)
      throws InterruptedException {
    VariableWatch watch = new VariableWatch(link, service, name);
    ConfigurationVariable found =
        RemoteConfiguration.variable(new RemoteConfiguration(link).of(service), name);
    watch.unit = found.unit();
    watch.values.add(new Value(link.clock().micros(), found.value(), found.unit(), ""));
    link.listen(Channels.CONFIGURATION, watch.listener);
    return watch;
  }

  private void take(U2SAData message) {
    if (message instanceof ConfigurationTransactionResult result
        && result.accepted()
        && result.serviceName().equals(service)) {
      for (ConfigurationAssignment each : result.assignments()) {
        if (each.variableName().equals(name)) {
          values.add(new Value(link.clock().micros(), each.value(), unit, result.author()));
        }
      }
    }
  }

  /** The next value; empty if none comes in that time. */
  public Optional<Value> next(long millis) throws InterruptedException {
    return Optional.ofNullable(values.poll(millis, TimeUnit.MILLISECONDS));
  }

  @Override
  public void close() {
    link.listenNoMore(Channels.CONFIGURATION, listener);
  }
}
