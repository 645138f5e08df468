package org.u2sa.android.vehicle

import android.content.Context
import android.content.SharedPreferences
import org.u2sa.android.board.BoardChoice
import org.u2sa.interfaces.BadInputException

/** User settings, stored by Android; each call reads or writes immediately. */
class PhoneSettings(context: Context) {
    private val store: SharedPreferences = context.getSharedPreferences("vehicle", Context.MODE_PRIVATE)

    /** Name of the system file among the vehicle's files. */
    var system: String by text("system", "shipped/config/ugv/system-board.xml")

    /** Name of the mission among the vehicle's files; empty for the configured one. */
    var mission: String by text("mission", "")

    /** Board connection; USB by default and if the stored value is invalid. */
    var board: BoardChoice
        get() = try {
            BoardChoice.parse(boardText)
        } catch (e: BadInputException) {
            BoardChoice.Usb.also { boardText = it.toString() }
        }
        set(value) {
            boardText = value.toString()
        }

    private var boardText: String by text("board", BoardChoice.Usb.toString())

    /** Phone battery level below which the vehicle is stopped [%]. */
    var lowBatteryPercent: Int
        get() = store.getInt("low battery", 15)
        set(value) = store.edit().putInt("low battery", value.coerceIn(0, 100)).apply()

    /** Whether ground stations may connect as configured; otherwise none can. */
    var network: Boolean by flag("network", false)

    /** Whether faults are announced by speech. */
    var speak: Boolean by flag("speak", true)

    private class Entry<T>(val get: () -> T, val set: (T) -> Unit) {
        operator fun getValue(owner: PhoneSettings, property: kotlin.reflect.KProperty<*>): T = get()

        operator fun setValue(owner: PhoneSettings, property: kotlin.reflect.KProperty<*>, value: T) = set(value)
    }

    private fun text(name: String, ifAbsent: String) =
        Entry({ store.getString(name, ifAbsent) ?: ifAbsent }, { store.edit().putString(name, it).apply() })

    private fun flag(name: String, ifAbsent: Boolean) =
        Entry({ store.getBoolean(name, ifAbsent) }, { store.edit().putBoolean(name, it).apply() })
}
