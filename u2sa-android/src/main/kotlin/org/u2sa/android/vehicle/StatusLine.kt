package org.u2sa.android.vehicle

import android.content.Context
import org.u2sa.android.text.Text
import org.u2sa.messages.safety.FailsafeAction

/** One-sentence vehicle status for the notification and the top of the screen. */
internal class StatusLine(val words: String, val level: Level) {
    enum class Level { IDLE, GOOD, MOVING, WRONG }

    companion object {
        fun of(context: Context, state: VehicleHost.State, snapshot: VehicleSnapshot): StatusLine = when (state.phase) {
            VehicleHost.Phase.STOPPED -> StatusLine(Text.PHASE_STOPPED.of(context), Level.IDLE)
            VehicleHost.Phase.STARTING -> StatusLine(Text.PHASE_STARTING.of(context), Level.IDLE)
            VehicleHost.Phase.STOPPING -> StatusLine(Text.PHASE_STOPPING.of(context), Level.IDLE)
            VehicleHost.Phase.FAILED -> StatusLine(Text.PHASE_FAILED.of(context, state.words), Level.WRONG)
            VehicleHost.Phase.CRASHED -> StatusLine(Text.PHASE_CRASHED.of(context), Level.WRONG)
            VehicleHost.Phase.RUNNING -> running(context, snapshot)
        }

        private fun running(context: Context, snapshot: VehicleSnapshot): StatusLine = when {
            snapshot.emergency != null -> StatusLine(Text.PHASE_EMERGENCY.of(context, snapshot.emergency), Level.WRONG)
            snapshot.failsafe != FailsafeAction.CONTINUE -> StatusLine(
                Text.FAILSAFE.of(context, snapshot.failsafe.name, snapshot.causes.joinToString("; ")), Level.WRONG,
            )
            snapshot.armed -> StatusLine(Text.PHASE_ARMED.of(context), Level.MOVING)
            else -> StatusLine(Text.PHASE_DISARMED.of(context), Level.GOOD)
        }
    }
}
