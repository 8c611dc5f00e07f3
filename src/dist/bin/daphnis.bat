@echo off
rem Runs daphnis with Java 17 or newer, or with the Java of an image. JAVA_OPTS reaches the JVM.
rem The script for sh beside this one also shares classes among starts and uses the vector unit.
setlocal
set "HOME_DIR=%~dp0.."
set "JAVA=java"
if defined JAVA_HOME set "JAVA=%JAVA_HOME:"=%\bin\java.exe"
if exist "%HOME_DIR%\jre\bin\java.exe" set "JAVA=%HOME_DIR%\jre\bin\java.exe"
"%JAVA%" -version >nul 2>&1
if errorlevel 1 (
    echo daphnis: no java found; install Java 17 or newer, or set JAVA_HOME>&2
    exit /b 1
)
pushd "%HOME_DIR%"
for %%J in (daphnis*.jar) do set "JAR=%HOME_DIR%\%%J"
popd
"%JAVA%" -Dsun.misc.unsafe.memory.access=allow -Xms8m -XX:+UseSerialGC -XX:MaxNewSize=64m %JAVA_OPTS% -jar "%JAR%" %*
exit /b %ERRORLEVEL%
