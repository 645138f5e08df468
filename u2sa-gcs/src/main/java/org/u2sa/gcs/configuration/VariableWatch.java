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
 * Watches a variable of a running service: its value, and each later change by messages. Changes
 * that a service makes to its own file are not detected.
 */
public final class VariableWatch implements AutoCloseable {
  /**
   * A value.
   *
   * @param micros time of receipt [µs of real time]
   * @param text value in the declared unit
   * @param unit declared unit; empty if none
   * @param author self-declared author of the change; empty for the first value
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
   * Requests the value and starts listening.
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

  /** Returns the next value; empty on timeout. */
  public Optional<Value> next(long millis) throws InterruptedException {
    return Optional.ofNullable(values.poll(millis, TimeUnit.MILLISECONDS));
  }

  @Override
  public void close() {
    link.listenNoMore(Channels.CONFIGURATION, listener);
  }
}
