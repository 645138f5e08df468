package org.u2sa.gcs.ros;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.socket.ClientSocket;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.safety.ManualDrive;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.message.MessageFromJson;

/**
 * One client's subscriptions and advertisements, and the operations of the protocol. Confined to
 * the client's thread, except for the vehicle's messages, which arrive on the transport's thread.
 */
final class RosbridgeSession {
  private static final int MAX_SUBSCRIPTIONS = 256;
  private static final int MAX_ADVERTISED = 256;
  private static final long MAX_UNREAD = // space for answers, beyond that for messages
      Runtime.getRuntime().maxMemory() / 256;
  private static final String TOPIC = "topic";
  private static final String TYPE = "type";

  private final RosbridgeServer server;
  private final ClientSocket socket;
  private final RosAccount account;
  private final Map<String, RosSubscription> subscriptions = new ConcurrentHashMap<>(); // by ID
  private final Map<String, Consumer<U2SAData>> listeners = new HashMap<>(); // by channel
  private final Map<String, String> advertised = new HashMap<>(); // type by topic
  private Optional<String> driver =
      Optional.empty(); // name of the person driving by hand through this client
  private final AtomicLong dropped = new AtomicLong();
  private final RosBacklog backlog = RosBacklog.outgoing();

  RosbridgeSession(RosbridgeServer server, ClientSocket socket, RosAccount account) {
    this.server = server;
    this.socket = socket;
    this.account = account;
  }

  /**
   * Executes one operation.
   *
   * @throws RuntimeException if it is refused; the message says why
   */
  void take(RosOperation operation) {
    switch (operation.name()) {
      case "subscribe" -> subscribe(operation);
      case "unsubscribe" -> unsubscribe(operation);
      case "advertise" -> advertise(operation);
      case "unadvertise" -> advertised.remove(operation.topic());
      case "publish" -> publish(operation);
      case "auth" -> authenticate(operation);
      case "set_level", "status" -> {} // only errors and warnings are reported
      default ->
          throw new BadInputException(
              "\""
                  + operation.name()
                  + "\" is not served; expected subscribe, unsubscribe, advertise, unadvertise,"
                  + " publish, call_service or auth");
    }
  }

  private void authenticate(RosOperation operation) {
    if (operation.has("mac")) {
      throw new BadInputException(
          "auth: MACs of rosauth are not accepted; expected \"user\" and \"password\"");
    }
    account.as(operation.text("user"), operation.text("password"));
    account.link();
  }

  private void subscribe(RosOperation operation) {
    RosTopic topic = server.topic(operation.topic());
    String type = operation.optionalText(TYPE);
    if (!type.isEmpty() && !RosSpelling.ros2(type).equals(topic.type())) {
      throw new BadInputException(
          "topic \"" + topic.name() + "\" is of type " + topic.type() + ", not " + type);
    }
    String compression = operation.optionalText("compression");
    if (!compression.isEmpty() && !compression.equals("none")) {
      throw new BadInputException("compression \"" + compression + "\": expected none");
    }
    if (operation.has("fragment_size")) {
      throw new BadInputException("fragment_size: messages are sent whole; expected none");
    }
    if (subscriptions.size() >= MAX_SUBSCRIPTIONS) {
      throw new BadInputException("there are " + MAX_SUBSCRIPTIONS + " subscriptions already");
    }
    String name = operation.topic();
    RosSpelling spelling = RosSpelling.of(type);
    RosSubscription made =
        new RosSubscription(
            topic,
            operation.count("throttle_rate"),
            operation.count("queue_length"),
            backlog,
            message -> text(name, spelling, message),
            this::send,
            server::later,
            server.clock());
    RosSubscription old = subscriptions.put(operation.idOr(name), made);
    if (old != null) {
      old.end();
    }
    RemoteLink link = account.link();
    for (Channel<?> channel : topic.sources()) {
      listen(link, channel);
    }
  }

  /** Resubscribes to a channel, so that retained messages are delivered again. */
  private void listen(RemoteLink link, Channel<?> channel) {
    Consumer<U2SAData> before = listeners.get(channel.name());
    if (before != null && channel.isRetained()) {
      link.unsubscribe(channel);
    } else if (before != null) {
      return;
    }
    Consumer<U2SAData> listener = message -> hear(channel, message);
    listeners.put(channel.name(), listener);
    link.listen(channel, listener);
  }

  private void hear(Channel<?> channel, U2SAData message) {
    if (channel.equals(Channels.STATE) && message instanceof StateInformation state) {
      server.frames().pose(state); // the first one is the map's origin
    }
    server.writing().lock();
    try {
      write(channel, message);
    } finally {
      server.writing().unlock();
    }
  }

  private void write(Channel<?> channel, U2SAData message) {
    Map<RosTopic, Optional<Object>> made = new HashMap<>();
    for (RosSubscription subscription : subscriptions.values()) {
      if (subscription.topic().sources().contains(channel)) {
        made.computeIfAbsent(subscription.topic(), topic -> topic.maker().apply(channel, message))
            .ifPresent(subscription::offer);
      }
    }
  }

  private static String text(String topic, RosSpelling spelling, Object message) {
    return new JsonText()
        .put("op", "publish")
        .put(TOPIC, topic)
        .put("msg", spelling.json(message))
        .line();
  }

  private void send(Supplier<String> text) {
    if (socket.isWritable()) {
      socket.text(text.get());
      return;
    }
    long count = dropped.incrementAndGet();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: reports need space too
      status("warning", "reads too slowly: " + count + " messages not sent so far", "");
    }
  }

  private void unsubscribe(RosOperation operation) {
    String name = operation.topic();
    RosTopic topic = server.topic(name);
    String id = operation.idOr("");
    subscriptions
        .entrySet()
        .removeIf(
            each -> {
              boolean isMeant =
                  each.getValue().topic().equals(topic)
                      && (id.isEmpty() || each.getKey().equals(id));
              if (isMeant) {
                each.getValue().end();
              }
              return isMeant;
            });
    for (Channel<?> channel : topic.sources()) {
      boolean isHeard =
          subscriptions.values().stream()
              .anyMatch(each -> each.topic().sources().contains(channel));
      if (!isHeard && listeners.remove(channel.name()) != null) {
        account.link().unsubscribe(channel);
      }
    }
  }

  private void advertise(RosOperation operation) {
    String topic = operation.topic();
    if (!server.topic(topic).name().equals(RosTwist.TOPIC)) {
      commandChannel(topic);
    }
    if (advertised.size() >= MAX_ADVERTISED) {
      throw new BadInputException("there are " + MAX_ADVERTISED + " topics advertised already");
    }
    advertised.put(topic, operation.optionalText(TYPE));
  }

  private Channel<?> commandChannel(String topic) {
    return server
        .topic(topic)
        .nativeChannel()
        .orElseThrow(
            () ->
                new BadInputException(
                    "topic \""
                        + topic
                        + "\" is published by the vehicle; orders go to /u2sa/… topics"));
  }

  private void publish(RosOperation operation) {
    if (server.topic(operation.topic()).name().equals(RosTwist.TOPIC)) {
      publishTwist(operation.object("msg"));
      return;
    }
    Channel<?> channel = commandChannel(operation.topic());
    Map<String, Object> fields = operation.object("msg");
    MessageFromJson reader = new MessageFromJson(server.messageTypes());
    MessageType<?> type =
        reader.named("msg", fields, declared(operation.topic()).or(() -> only(channel)));
    if (!channel.carries(type)) {
      throw new BadInputException(
          "\""
              + channel
              + "\" does not carry a "
              + type.name()
              + "; it carries "
              + channel.carriedTypes().stream().map(MessageType::name).toList());
    }
    account.requireRight(channel, type);
    U2SAData message = reader.message("msg", type, fields);
    account.link().publish(channel, message);
    if (message instanceof ManualOrder order && order.active()) {
      driver = Optional.of(order.operator());
    }
  }

  private void publishTwist(Map<String, Object> twist) {
    account.requireRight(Channels.MANUAL_DRIVE, ManualDrive.TYPE);
    String operator =
        driver.orElseThrow(
            () ->
                new BadInputException(
                    RosTwist.TOPIC
                        + " takes effect only after a ManualOrder on /u2sa/manual_orders (docs/ros.md#drive)"));
    account.link().publish(Channels.MANUAL_DRIVE, RosTwist.drive(twist, operator));
  }

  private Optional<MessageType<?>> declared(String topic) {
    String name = advertised.getOrDefault(topic, "").replaceFirst(".*/", "");
    return server.messageTypes().byName(name).filter(type -> !type.isAbstract()).map(t -> t);
  }

  private static Optional<MessageType<?>> only(Channel<?> channel) {
    List<MessageType<?>> carried = channel.carriedTypes();
    return carried.size() == 1 && !carried.get(0).isAbstract()
        ? Optional.of(carried.get(0))
        : Optional.empty();
  }

  /** Calls a service and answers; called on its own thread, because it may take seconds. */
  void call(RosOperation operation) throws InterruptedException {
    JsonText answer = new JsonText().put("op", "service_response");
    String service = operation.text("service");
    answer.put("id", operation.idOr("")).put("service", service);
    try {
      Map<String, Object> values =
          server.services().call(service, operation.object("args"), account);
      answer.put("values", timesOfBoth(values)).put("result", true);
    } catch (RuntimeException e) {
      answer.put("values", String.valueOf(e.getMessage())).put("result", false);
    }
    answer(answer);
  }

  /** Sends a message that must not be dropped; disconnects a client that leaves too many unread. */
  private void answer(JsonText text) {
    if (socket.backlog() > MAX_UNREAD) {
      socket.close();
    } else {
      socket.text(text.line());
    }
  }

  /** Answers are spelled as in ROS 2, except that times also have ROS 1 names. */
  private static Object timesOfBoth(Map<String, Object> values) {
    if (values.get("time") instanceof RosSpelling.Time time) {
      long nanos = time.nanos();
      long second = 1_000_000_000L;
      return new JsonText()
          .put(
              "time",
              new JsonText()
                  .put("sec", nanos / second)
                  .put("nanosec", nanos % second)
                  .put("secs", nanos / second)
                  .put("nsecs", nanos % second));
    }
    return RosSpelling.ROS_2.json(values);
  }

  /** Reports an error to the client. */
  void status(String level, String text, String id) {
    JsonText status = new JsonText().put("op", "status").put("level", level).put("msg", text);
    answer(id.isEmpty() ? status : status.put("id", id));
  }

  void end() {
    subscriptions.values().forEach(RosSubscription::end);
    account.close();
  }
}
