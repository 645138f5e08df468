package org.u2sa.android.vehicle

import org.u2sa.messages.safety.FailsafeAction

/** Detects new faults so that each is announced once. Not thread-safe. */
internal class Warnings {
    /** A fault: a [hazard] of the phone, or text from the vehicle. */
    class Warning(val kind: Kind, val words: String, val hazard: PhoneFailsafe.Hazard? = null)

    enum class Kind { EMERGENCY, FAILSAFE, HAZARD }

    private var before = VehicleSnapshot()

    /** Faults in [now] that were not in the previous snapshot, worst first. */
    fun news(now: VehicleSnapshot): List<Warning> {
        val was = before
        before = now
        return buildList {
            if (now.emergency != null && was.emergency == null) {
                add(Warning(Kind.EMERGENCY, now.emergency))
            }
            if (now.failsafe != FailsafeAction.CONTINUE && now.failsafe != was.failsafe) {
                add(Warning(Kind.FAILSAFE, "${now.failsafe.name}: ${now.causes.joinToString("; ")}"))
            }
            (now.hazards - was.hazards.toSet()).forEach { add(Warning(Kind.HAZARD, "", it)) }
        }
    }
}
