/**
 * Configuration variables and their files: declaration, validation, change, undo. XML parsing
 * belongs to {@code interfaces.xml}.
 */
package org.u2sa.interfaces.configuration;
