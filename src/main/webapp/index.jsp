<%@ page contentType="text/html; charset=UTF-8" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>Toqa</title>
<link rel="stylesheet" href="<c:url value='/assets/pico.min.css'/>">
</head>
<body>
<main class="container">
<h1><c:out value="Toqa"/></h1>
</main>
</body>
</html>
