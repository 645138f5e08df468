package org.u2sa.android.vehicle

import android.content.Context
import android.content.SharedPreferences
import org.u2sa.android.board.BoardChoice
import org.u2sa.interfaces.BadInputException

/** What the user chose. Kept by Android; each call reads or writes it at once. */
class PhoneSettings(context: Context) {
    private val store: SharedPreferences = context.getSharedPreferences("vehicle", Context.MODE_PRIVATE)

    /** The system file's name among the vehicle's files. */
    var system: String by text("system", "shipped/config/ugv/system-board.xml")

    /** The mission's name among the vehicle's files; empty: the one of the configuration. */
    var mission: String by text("mission", "")

    /** The way to the board; by the USB cable until another one is chosen, or if what is stored cannot be read. */
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

    /** Charge of the phone below which the vehicle is stopped [%]. */
    var lowBatteryPercent: Int
        get() = store.getInt("low battery", 15)
        set(value) = store.edit().putInt("low battery", value.coerceIn(0, 100)).apply()

    /** Whether ground stations may connect as the configuration says; otherwise none can. */
    var network: Boolean by flag("network", false)

    /** Whether what goes wrong is said aloud. */
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
