package org.u2sa.mission;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.mission.MissionVariables.Resumption;

/**
 * Saves mission progress and restores that of an earlier process, as configured by RESUME. Not
 * thread-safe.
 */
final class Resumable {
  private final MissionManager manager;
  private final SavedMission saved;
  private final Supplier<MissionVariables> settings;
  private Optional<MissionProgress> found = Optional.empty();
  private String foundDigest = ""; // of the mission whose progress was loaded
  private long notSaved;

  Resumable(MissionManager manager, SavedMission saved, Supplier<MissionVariables> settings) {
    this.manager = manager;
    this.saved = saved;
    this.settings = settings;
  }

  /**
   * Loads the progress of an earlier process. Returns it if it must be resumed immediately; else
   * empty.
   */
  Optional<MissionProgress> atStart() {
    Resumption rule = settings.get().resume();
    if (rule == Resumption.NEVER) {
      return Optional.empty();
    }
    try {
      foundDigest = SavedMission.digest(file());
      found = saved.read(file(), settings.get().loop(), settings.get().options());
    } catch (IOException e) {
      manager.log(LogLevelEnum.WARN, e.getMessage() + ": starting the mission from its first goal");
    }
    if (rule == Resumption.ALWAYS) {
      found.ifPresent(before -> manager.log("resuming the mission of the process before"));
      return taken();
    }
    found.ifPresent(
        before ->
            manager.log(
                LogLevelEnum.WARN,
                "the process before ended at goal "
                    + before.mission().currentNames()
                    + ": the order resume goes on there"));
    return Optional.empty();
  }

  private Path file() {
    return Paths.get(manager.mission().origin());
  }

  /** Takes the loaded progress, once. */
  Optional<MissionProgress> taken() {
    Optional<MissionProgress> taken = found;
    found = Optional.empty();
    return taken;
  }

  /** Discards the loaded progress if it is of another mission than the one that begins now. */
  void forgetOther() {
    found = found.filter(before -> isOf(file()));
  }

  private boolean isOf(Path mission) {
    try {
      return SavedMission.digest(mission).equals(foundDigest);
    } catch (IOException e) {
      manager.log(
          LogLevelEnum.WARN, e + ": the order resume no longer goes on at " + where().orElse(""));
      return false;
    }
  }

  /** Where {@link #taken} would resume, in words. */
  Optional<String> where() {
    return found.map(before -> String.join(", ", before.mission().currentNames()));
  }

  /** Saves the progress; a completed mission is not resumed. */
  void save(MissionProgress progress) {
    boolean keepsFound = found.isPresent() && progress.isFresh();
    if (settings.get().resume() == Resumption.NEVER || keepsFound) {
      return;
    }
    try {
      if (progress.mission().isOver()) {
        saved.delete();
      } else {
        saved.write(progress, file());
      }
    } catch (IOException e) { // such as a full disk: not fatal
      notSaved++;
      if (Long.bitCount(notSaved) == 1) { // 1, 2, 4, 8…: may persist
        manager.log(
            LogLevelEnum.ERROR, "the mission was not saved, it cannot be resumed from here: " + e);
      }
    }
  }
}
