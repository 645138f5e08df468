package org.u2sa.cli.record;

import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.schema.U2SAData;

/**
 * Receiver for a connection without subscriptions.
 *
 * @param trouble called when the connection is lost or restored
 */
record PublisherOnly(Consumer<String> trouble) implements Receiver {
  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    throw new IllegalStateException("subscribed to nothing, but received " + message);
  }

  @Override
  public void trouble(String what) {
    trouble.accept(what);
  }
}
