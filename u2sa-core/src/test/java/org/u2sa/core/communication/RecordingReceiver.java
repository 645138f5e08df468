package org.u2sa.core.communication;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.schema.U2SAData;

/** Keeps what it is handed. */
final class RecordingReceiver implements Receiver {
  final List<U2SAData> messages = new CopyOnWriteArrayList<>();
  final List<String> troubles = new CopyOnWriteArrayList<>();

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    messages.add(message);
  }

  @Override
  public void trouble(String what) {
    troubles.add(what);
  }

  void awaitMessage(U2SAData message) {
    BrokerTraffic.soon().until(() -> messages.contains(message));
  }

  void awaitTrouble(String word) {
    BrokerTraffic.soon().until(() -> troubles.stream().anyMatch(line -> line.contains(word)));
  }
}
