package org.u2sa.mission;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.mission.MissionVariables.Resumption;

/**
 * Saves mission progress and restores that of an earlier process, as configured by RESUME. Not
 * thread-safe.
 */
final class Resumable {
  private final MissionRun run;
  private final Logger logger;
  private final SavedMission saved;
  private final Supplier<String> digest; // of the mission file as loaded
  private final Supplier<MissionVariables> settings;
  private Optional<MissionProgress> found = Optional.empty();
  private String foundDigest = ""; // of the mission whose progress was loaded
  private boolean hasFile = true; // whether the mission comes from the file
  private final AtomicLong notSaved = new AtomicLong();

  Resumable(
      MissionRun run,
      SavedMission saved,
      Supplier<String> digest,
      Supplier<MissionVariables> settings,
      Logger logger) {
    this.run = run;
    this.logger = logger;
    this.saved = saved;
    this.digest = digest;
    this.settings = settings;
  }

  /**
   * Loads the progress of an earlier process. Returns the saved progress if it must be resumed
   * immediately; otherwise empty.
   */
  Optional<MissionProgress> atStart() {
    Resumption rule = settings.get().resume();
    if (rule == Resumption.NEVER) {
      return Optional.empty();
    }
    try {
      foundDigest = digest.get();
      found =
          saved.read(
              run.mission().origin(), foundDigest, settings.get().loop(), settings.get().options());
    } catch (IOException e) {
      logger.log(LogLevelEnum.WARN, e.getMessage() + ": starting the mission from its first goal");
    }
    if (rule == Resumption.ALWAYS) {
      found.ifPresent(
          before -> logger.log(LogLevelEnum.INFO, "resuming the mission of the previous process"));
      return taken();
    }
    found.ifPresent(
        before ->
            logger.log(
                LogLevelEnum.WARN,
                String.format(
                    "the previous process ended at goal %s: order resume to continue there",
                    before.mission().currentNames())));
    return Optional.empty();
  }

  /** Consumes the loaded progress. */
  Optional<MissionProgress> taken() {
    Optional<MissionProgress> taken = found;
    found = Optional.empty();
    return taken;
  }

  /**
   * Ends a pause; otherwise resumes where the previous process ended, or returns to the interrupted
   * goal.
   *
   * @return description of the position at which the mission resumes
   * @throws BadInputException if there is nothing to resume
   */
  String resume() {
    boolean wasPaused = run.progress().isPaused() && !run.progress().mission().isOver();
    Optional<MissionProgress> before = wasPaused ? Optional.empty() : taken();
    before.ifPresent(run::progress);
    MissionProgress progress = run.progress();
    progress.pause(false);
    if (before.isEmpty() && !wasPaused && !progress.goBack()) {
      throw new BadInputException(
          progress.isLeft()
              ? "the failsafe "
                  + progress.pursuedFor()
                  + " is pursued; the mission resumes after it"
              : "nothing to resume: the mission was not interrupted");
    }
    return "resumed at "
        + List.copyOf(progress.mission().currentNames())
        + (progress.isLeft() ? ", after the failsafe " + progress.pursuedFor() : "");
  }

  /** Stops saving: the mission comes from no file, so another process could not resume it. */
  void leaveFile() {
    hasFile = false;
    found = Optional.empty();
    if (settings.get().resume() != Resumption.NEVER) {
      saved.delete(this::notSaved);
    }
  }

  /** Discards the loaded progress if it belongs to a mission other than the starting one. */
  void forgetOther() {
    hasFile = true;
    found = found.filter(before -> digest.get().equals(foundDigest));
  }

  /** Description of the position at which {@link #taken} would resume. */
  Optional<String> where() {
    return found.map(before -> String.join(", ", before.mission().currentNames()));
  }

  /** Saves the progress; a completed mission is not resumed. */
  void save(MissionProgress progress) {
    boolean keepsFound = found.isPresent() && progress.isFresh();
    if (settings.get().resume() == Resumption.NEVER || keepsFound || !hasFile) {
      return;
    }
    if (progress.mission().isOver()) {
      saved.delete(this::notSaved);
    } else {
      saved.write(progress, digest.get(), this::notSaved);
    }
  }

  /** Reports that saving failed, e.g. because the disk is full; not fatal. */
  private void notSaved(IOException why) {
    if (Long.bitCount(notSaved.incrementAndGet()) == 1) { // 1, 2, 4, 8…: may persist
      logger.log(
          LogLevelEnum.ERROR, "the mission was not saved and cannot be resumed from here: " + why);
    }
  }
}
