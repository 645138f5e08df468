package org.u2sa.cli.look;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.function.BooleanSupplier;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ListeningTime;
import org.u2sa.cli.record.RecordingParts;
import org.u2sa.cli.record.SpanOptions;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.MessageStream;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.view.RecordedView;
import org.u2sa.gcs.view.ViewFeed;
import org.u2sa.gcs.view.ViewServer;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.recorder.playback.RecordedMessages;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa view}: shows a running system or a recording in Foxglove and Lichtblick. */
@Command(
    name = "view",
    description = {
      "Serve a running system, or a recording, to Foxglove and Lichtblick.",
      "",
      "  ./u2sa view                          the system at localhost:1883",
      "  ./u2sa view --connect --broker vehicle.local",
      "  ./u2sa view recording.mcap --rate 4 --loop",
      "",
      "Then open a Foxglove WebSocket connection to ws://localhost:8765. Viewers get each message as JSON, and the same views as in a recording "
          + "(docs/recording.md). They are read-only: nothing they send reaches a service. A "
          + "viewer that reads too slowly loses messages, which are counted; it does not delay "
          + "others."
    })
public final class ViewCommand extends BaseCommand {
  private static final long LOOK_MS = 100;
  private static final long NANOS = 1_000L;

  @Mixin private RemoteSystem remote;
  @Mixin private ListeningTime time;

  @Parameters(
      arity = "0..1",
      paramLabel = "FILE",
      description = "A recording (MCAP). Default: the running system.")
  private Path file;

  @Option(names = "--connect", description = "Show the running system; the default without FILE.")
  private boolean connect;

  @Option(
      names = "--port",
      paramLabel = "PORT",
      defaultValue = "8765",
      description = "TCP port to listen on; 0: any free port. Default: ${DEFAULT-VALUE}.")
  private int port;

  @Option(
      names = "--bind",
      paramLabel = "ADDRESS",
      defaultValue = "127.0.0.1",
      description =
          "Address to listen on; 0.0.0.0 lets anyone on the network watch, unencrypted. Default: "
              + "${DEFAULT-VALUE}.")
  private String bind;

  @Option(
      names = "--origin",
      paramLabel = "ORIGIN",
      description =
          "Additional web page whose viewer may connect, such as https://viewer.example; repeatable, '*' for all. Always allowed: pages of this host, Foxglove's, and programs other than browsers.")
  private Set<String> origins = Set.of();

  @Option(
      names = "--rate",
      paramLabel = "X",
      defaultValue = "1",
      description = "For a recording: speed relative to the original. Default: ${DEFAULT-VALUE}.")
  private double rate;

  @Mixin private SpanOptions part;

  @Option(names = "--loop", description = "For a recording: restart at the end.")
  private boolean loop;

  @Override
  public Integer call() throws IOException, InterruptedException {
    check();
    if (file == null) {
      try (RemoteLink link = remote.connect()) {
        live(link);
      }
    } else {
      try (RecordedMessages recording = RecordedMessages.open(file)) {
        RecordingParts.othersNotRead(file).ifPresent(this::tell);
        recorded(recording);
      }
    }
    return ExitCode.DONE;
  }

  private void check() {
    if (file != null && connect) {
      throw wrong("--connect and " + file + ": expected one of them");
    }
    if (port < 0 || port > 65_535) {
      throw wrong("--port " + port + ": expected 0…65535");
    }
    if (!(rate > 0.0 && rate <= 1e6)) {
      throw wrong("--rate " + rate + ": expected more than 0, at most 1000000");
    }
  }

  private void live(RemoteLink link) throws InterruptedException {
    MessageStream stream = new MessageStream(link);
    Channels.all().forEach(stream::of);
    try (ViewServer server = server("u2sa " + link.systemId(), false)) {
      ViewFeed feed = new ViewFeed(server, link.systemId(), true);
      long began = link.clock().micros();
      while (!time.isOver(began, link.clock().micros())) {
        Optional<MessageStream.Heard> heard = stream.next(LOOK_MS);
        heard.ifPresent(each -> feed.take(each.channel(), each.message(), each.micros() * NANOS));
      }
    }
    if (stream.dropped() > 0) {
      tell(stream.dropped() + " messages came faster than they were served");
    }
  }

  private void recorded(RecordedMessages recording) throws IOException, InterruptedException {
    Clock clock = new SystemClock();
    long began = clock.micros();
    BooleanSupplier isOver = () -> time.isOver(began, clock.micros());
    try (ViewServer server = server("u2sa " + file.getFileName(), true)) {
      new RecordedView(recording, clock, isOver)
          .play(server, rate, part.of(recording.reader()), loop);
    }
  }

  private ViewServer server(String name, boolean tellsTime) {
    InetSocketAddress address;
    try {
      address = new InetSocketAddress(InetAddress.getByName(bind), port);
    } catch (UnknownHostException e) {
      throw wrong("--bind " + bind + ": no such address");
    }
    ViewServer server =
        new ViewServer(address, name, UUID.randomUUID().toString(), tellsTime, origins, this::tell);
    String host = address.getAddress().isLoopbackAddress() ? "localhost" : bind;
    print(
        "Serving "
            + name
            + " at ws://"
            + host
            + ":"
            + server.address().getPort()
            + " (Foxglove WebSocket). Ctrl-C ends it.");
    out().flush();
    return server;
  }
}
