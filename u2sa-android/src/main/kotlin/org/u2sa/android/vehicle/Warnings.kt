package org.u2sa.android.vehicle

import org.u2sa.messages.contract.FailsafeAction

/** Tells what has newly gone wrong, so that each thing is said once. Not safe for several threads. */
internal class Warnings {
    /** What may be wrong: [hazard] of the phone, or the vehicle's own words. */
    class Warning(val kind: Kind, val words: String, val hazard: PhoneFailsafe.Hazard? = null)

    enum class Kind { EMERGENCY, FAILSAFE, HAZARD }

    private var before = VehicleSnapshot()

    /** What is wrong in [now] and was not in the snapshot before; the worst first. */
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
