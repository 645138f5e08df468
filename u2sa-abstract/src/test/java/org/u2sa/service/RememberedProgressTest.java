package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.handover.RememberedStates;

/** What a service knows after it was started again. */
@Timeout(120)
class RememberedProgressTest {
  private static final Path FULL = Path.of("/dev/full"); // every write fails

  @TempDir private Path directory;
  private final LockstepClock clock = new LockstepClock();
  private final LocalBus bus = new LocalBus("test");
  private Learner learner;
  private RememberedStates remembered; // of the process; null: each service is in its own

  /** Remembers the last command; every kind of value is handed over. */
  private static final class Learner extends EventDrivenService {
    private String learnt = "nothing";
    private HandOver taken;

    Learner(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Learner");
      registerSubscriber(Channels.GOAL_COMMANDS);
    }

    @Override
    public void callback(U2SAData data) {
      learnt = ((GoalCommand) data).uid();
      remember();
    }

    @Override
    protected void handOver(HandOver state) {
      state
          .text("LEARNT", learnt)
          .number("PI", Math.PI)
          .flag("SURE", true)
          .texts("WORDS", List.of("a\tb", "", "c\\d\r\n"))
          .texts("NO WORDS", List.of())
          .message("PLACE", new Waypoint().uid("x").x(1.5).horizontalThreshold(2.0))
          .messages(
              "PLACES",
              List.of(
                  new Waypoint().uid("y").horizontalThreshold(2.0), new GoalCommand().uid("z")));
    }

    @Override
    protected void takeOver(HandOver state) {
      taken = state;
      learnt = state.text("LEARNT").orElseThrow();
      if (learnt.equals("poison")) {
        throw new IllegalStateException("cannot bear it");
      }
    }
  }

  @BeforeEach
  void startFirst() throws InterruptedException {
    start(false);
  }

  @AfterEach
  void close() {
    learner.kill();
  }

  private void start(boolean restart) throws InterruptedException {
    learner =
        new Learner(
            ServiceContext.of("test", XmlConfiguration.inMemory("test", Map.of()))
                .clock(clock)
                .transport(bus)
                .logDirectory(directory)
                .restart(restart)
                .remembered(remembered == null ? new RememberedStates() : remembered)
                .build());
    learner.start();
    clock.advance(0);
  }

  private void learn(String what) throws InterruptedException {
    GoalCommand command = new GoalCommand().uid(what);
    command.freeze();
    bus.deliver(Channels.GOAL_COMMANDS, command);
    clock.advance(0);
  }

  private void restart() throws InterruptedException {
    learner.kill();
    start(true);
  }

  private Path file() {
    return directory.resolve("Learner.progress");
  }

  @Test
  void restart_afterRemember_takesOverEveryKindOfValue() throws Exception {
    learn("line\nand tab\t");
    restart();

    assertThat(learner.learnt).isEqualTo("line\nand tab\t");
    assertThat(learner.taken.className()).isEqualTo(Learner.class.getName());
    assertThat(learner.taken.number("PI")).hasValue(Math.PI);
    assertThat(learner.taken.flag("SURE")).isTrue();
    assertThat(learner.taken.texts("WORDS")).containsExactly("a\tb", "", "c\\d\r\n");
    assertThat(learner.taken.texts("NO WORDS")).isEmpty();
    assertThat(learner.taken.message("PLACE", Waypoint.class).orElseThrow().x()).hasValue(1.5);
    assertThat(learner.taken.messages("PLACES", U2SAData.class)).hasSize(2);
  }

  /** Leaves no room for another file. */
  private void fillDisk() throws IOException {
    Files.createDirectories(directory.resolve("Learner.progress.tmp/in the way"));
  }

  private String remarks() {
    return learner.health.addTo(new HealthReport()).toString();
  }

  @Test
  void restart_afterTheDiskWasFull_takesOverTheNewestState() throws Exception {
    learn("old, and longer");
    fillDisk();
    learn("new");
    assertThat(remarks()).doesNotContain("STATE");
    restart();

    assertThat(learner.learnt).isEqualTo("new");
  }

  @Test
  void restart_fileWithRoomForMore_takesOverItsState() throws Exception {
    learn("something");
    Files.writeString(file(), "\n".repeat(1000), StandardOpenOption.APPEND);
    restart();

    assertThat(learner.learnt).isEqualTo("something");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void restart_afterNothingCouldBeWritten_knowsNothingRatherThanTheOldState() throws Exception {
    learn("old");
    fillDisk();
    Files.delete(file());
    Files.createSymbolicLink(file(), FULL);
    learn("new");
    restart();

    assertThat(learner.learnt).isEqualTo("nothing");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void restart_inTheSameProcessAfterTheDiskFailed_goesOnWithTheNewestState() throws Exception {
    learner.kill();
    remembered = new RememberedStates();
    start(false);
    learn("old");
    fillDisk();
    Files.delete(file());
    Files.createSymbolicLink(file(), FULL);
    learn("new");
    assertThat(log()).contains("the state was not saved");
    assertThat(file()).as("no old state").doesNotExist();
    assertThat(remarks()).contains("STATE: not saved");

    restart();
    assertThat(learner.learnt).isEqualTo("new");

    learner.kill();
    start(false);
    restart();
    assertThat(learner.learnt).as("of an earlier run").isEqualTo("nothing");
  }

  @Test
  void restart_nothingRemembered_beginsFromNothing() throws Exception {
    restart();

    assertThat(learner.learnt).isEqualTo("nothing");
  }

  @Test
  void firstStart_ofAnotherRun_forgetsWhatThatOneLeft() throws Exception {
    learn("old");
    learner.kill();
    start(false);
    assertThat(file()).doesNotExist();

    restart();

    assertThat(learner.learnt).isEqualTo("nothing");
  }

  @Test
  void restart_fileCutOff_beginsFromNothingAndSaysSo() throws Exception {
    learn("something");
    List<String> lines = Files.readAllLines(file());
    Files.write(file(), lines.subList(0, lines.size() - 1));

    restart();

    assertThat(learner.learnt).isEqualTo("nothing");
    assertThat(log()).contains("no saved state, starting fresh").contains("Learner.progress");
  }

  @Test
  void restart_valueDamaged_beginsFromNothingAndNamesTheLine() throws Exception {
    learn("something");
    Files.writeString(file(), Files.readString(file()).replace("number\tPI\t3", "number\tPI\tE"));

    restart();

    assertThat(learner.learnt).isEqualTo("nothing");
    assertThat(log()).contains("Learner.progress, line 3");
  }

  @Test
  void restart_serviceCannotGoOn_failsOnceAndThenBeginsFromNothing() throws Exception {
    learn("poison");
    assertThatThrownBy(this::restart).hasMessageContaining("cannot bear it");

    restart();

    assertThat(learner.learnt).isEqualTo("nothing");
  }

  @Test
  void remember_afterItWasGivenUp_leavesTheSuccessorsFileAlone() throws Exception {
    learn("mine");
    learner.kill();
    Files.delete(file());

    learner.remember();

    assertThat(file()).doesNotExist();
  }

  private String log() throws IOException {
    return Files.readString(directory.resolve("Learner.log"));
  }
}
